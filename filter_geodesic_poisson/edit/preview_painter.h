// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PREVIEW_PAINTER_H
#define FILTER_GEODESIC_POISSON_PREVIEW_PAINTER_H

#include "preview.h"
#include "view_choices.h"

#include <QOpenGLBuffer>
#include <QSize>
#include <cstddef>
#include <memory>

namespace gpr_filter {

/// The two ends of a background that fades from top to bottom; red, green, blue.
struct Background {
	unsigned char top[3], bottom[3];
};

/// Draws a result, and the result of Quadric Edge Collapse, with OpenGL's fixed pipeline. All calls
/// need the view's context to be current.
class PreviewPainter {
public:
	~PreviewPainter();

	/// Null for no result. Cheap; new data go to the graphics card with the next draw().
	void setResult(std::shared_ptr<const DrawnFaces> faces);
	void setQuadric(std::shared_ptr<const DrawnFaces> faces);
	bool hasResult() const { return result_.faces != nullptr; }
	bool hasQuadric() const { return quadric_.faces != nullptr; }

	/// transform: of the layer, sixteen numbers column by column; the view is set already. size: of
	/// the view in pixels. All of OpenGL's state is restored.
	void draw(const ViewChoices& choices, const float* transform, const QSize& size,
			  const Background& background);
	/// Gives the memory of the graphics card back.
	void release();

private:
	struct Sent {
		std::shared_ptr<const DrawnFaces> faces;
		QOpenGLBuffer                     buffer{QOpenGLBuffer::VertexBuffer};
		bool                              isSent = false;
	};
	Sent result_, quadric_;

	static void set(std::shared_ptr<const DrawnFaces> faces, Sent& sent);
	static bool send(Sent& sent);
	static void drawFaces(const ViewChoices& choices, Sent& sent);
};

} // namespace gpr_filter

#endif
