// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview_painter.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gpr_filter {

namespace {

const void* offset(std::size_t bytes)
{
	return reinterpret_cast<const void*>(bytes);
}

/// Keeps OpenGL's state for the life of the object.
class KeptState {
public:
	KeptState()
	{
		glPushAttrib(GL_ALL_ATTRIB_BITS);
		glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
		glMatrixMode(GL_MODELVIEW);
		glPushMatrix();
	}
	~KeptState()
	{
		glMatrixMode(GL_MODELVIEW);
		glPopMatrix();
		glPopClientAttrib();
		glPopAttrib();
	}
	KeptState(const KeptState&)            = delete;
	KeptState& operator=(const KeptState&) = delete;
};

/// Coordinates from -1 to 1 over the whole view for the life of the object.
class FlatView {
public:
	FlatView()
	{
		for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
			glMatrixMode(matrix);
			glPushMatrix();
			glLoadIdentity();
		}
		glDisable(GL_LIGHTING);
		glDisable(GL_DEPTH_TEST);
		glDisable(GL_TEXTURE_2D);
	}
	~FlatView()
	{
		for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
			glMatrixMode(matrix);
			glPopMatrix();
		}
	}
	FlatView(const FlatView&)            = delete;
	FlatView& operator=(const FlatView&) = delete;
};

void drawBackground(const Background& background)
{
	const FlatView flat;
	glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
	glDisable(GL_CULL_FACE);
	glBegin(GL_TRIANGLE_STRIP);
	for (const float x : {-1.0f, 1.0f}) {
		glColor3ubv(background.top);
		glVertex2f(x, 1);
		glColor3ubv(background.bottom);
		glVertex2f(x, -1);
	}
	glEnd();
}

/// Nothing outside of some columns of the view is drawn from here on.
void restrictTo(int fromColumn, int toColumn, int height)
{
	glEnable(GL_SCISSOR_TEST);
	glScissor(fromColumn, 0, std::max(0, toColumn - fromColumn), height);
}

void clearRestricted(const Background& background)
{
	glDepthMask(GL_TRUE);
	glClear(GL_DEPTH_BUFFER_BIT);
	drawBackground(background);
}

void drawWipeLine(double at)
{
	const FlatView flat;
	glDisable(GL_SCISSOR_TEST);
	const float x = float(2 * at - 1);
	for (const float width : {4.0f, 2.0f}) {
		const float grey = width > 3 ? 0.1f : 1.0f;
		glLineWidth(width);
		glColor3f(grey, grey, grey);
		glBegin(GL_LINES);
		glVertex2f(x, -1);
		glVertex2f(x, 1);
		glEnd();
	}
}

/// A lamp at the eye, which lights both sides.
void light()
{
	const float ahead[4] = {0, 0, 1, 0}, strong[4] = {0.75f, 0.75f, 0.75f, 1};
	const float weak[4] = {0.25f, 0.25f, 0.25f, 1}, none[4] = {0, 0, 0, 1};
	glMatrixMode(GL_MODELVIEW);
	glPushMatrix();
	glLoadIdentity();
	glLightfv(GL_LIGHT0, GL_POSITION, ahead);
	glPopMatrix();
	glLightfv(GL_LIGHT0, GL_DIFFUSE, strong);
	glLightfv(GL_LIGHT0, GL_AMBIENT, none);
	glLightfv(GL_LIGHT0, GL_SPECULAR, none);
	glLightModelfv(GL_LIGHT_MODEL_AMBIENT, weak);
	glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
	for (int i = 1; i < 8; ++i)
		glDisable(GLenum(GL_LIGHT0 + i));
	glEnable(GL_LIGHT0);
	glEnable(GL_LIGHTING);
	glEnable(GL_NORMALIZE);
	glEnable(GL_COLOR_MATERIAL);
	glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
}

std::size_t colourOffset(PreviewColour colour)
{
	return colour == PreviewColour::Distance ? offsetof(DrawnCorner, byDistance)
											 : offsetof(DrawnCorner, byQuality);
}

/// The result lies partly below the input, and both shall be visible.
bool isOverOriginal(const ViewChoices& choices)
{
	return choices.place == PreviewPlace::OverOriginal && !choices.isWiped;
}

void seeThrough()
{
	QOpenGLContext::currentContext()->functions()->glBlendColor(0, 0, 0, 0.5f);
	glEnable(GL_BLEND);
	glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
}

void fillTriangles(const ViewChoices& choices, int cornerNum)
{
	light();
	if (isOverOriginal(choices)) seeThrough();
	glEnable(GL_POLYGON_OFFSET_FILL);
	glPolygonOffset(1, 1); // lines are seen on the faces
	if (choices.colour == PreviewColour::None) {
		glColor3f(0.72f, 0.80f, 0.86f);
	}
	else {
		glEnableClientState(GL_COLOR_ARRAY);
		glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(DrawnCorner),
					   offset(colourOffset(choices.colour)));
	}
	glDrawArrays(GL_TRIANGLES, 0, cornerNum);
	glDisableClientState(GL_COLOR_ARRAY);
	glDisable(GL_POLYGON_OFFSET_FILL);
}

void outlineTriangles(const ViewChoices& choices, int cornerNum)
{
	glDisable(GL_LIGHTING);
	glDisable(GL_BLEND);
	glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
	glLineWidth(1);
	if (choices.faces && !isOverOriginal(choices))
		glColor3f(0.12f, 0.15f, 0.20f);
	else
		glColor3f(0.05f, 0.20f, 0.55f);
	glDrawArrays(GL_TRIANGLES, 0, cornerNum);
	glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

} // namespace

PreviewPainter::~PreviewPainter() = default;

void PreviewPainter::set(std::shared_ptr<const DrawnFaces> faces, Sent& sent)
{
	sent.faces  = std::move(faces);
	sent.isSent = false;
}

void PreviewPainter::setResult(std::shared_ptr<const DrawnFaces> faces)
{
	set(std::move(faces), result_);
}

void PreviewPainter::setQuadric(std::shared_ptr<const DrawnFaces> faces)
{
	set(std::move(faces), quadric_);
}

void PreviewPainter::release()
{
	for (Sent* sent : {&result_, &quadric_}) {
		sent->buffer.destroy();
		sent->isSent = false;
	}
}

/// Leaves the buffer bound; false if the graphics card has no room.
bool PreviewPainter::send(Sent& sent)
{
	if (!sent.buffer.isCreated() && !sent.buffer.create()) return false;
	if (!sent.buffer.bind()) return false;
	if (sent.isSent) return true;
	sent.buffer.allocate(sent.faces->data(), int(sent.faces->size() * sizeof(DrawnCorner)));
	sent.isSent = true;
	return true;
}

void PreviewPainter::drawFaces(const ViewChoices& choices, Sent& sent)
{
	if (sent.faces == nullptr || sent.faces->empty() || !send(sent)) return;
	const int cornerNum = int(sent.faces->size());
	glDisableClientState(GL_TEXTURE_COORD_ARRAY);
	glDisableClientState(GL_COLOR_ARRAY);
	glEnableClientState(GL_VERTEX_ARRAY);
	glEnableClientState(GL_NORMAL_ARRAY);
	glVertexPointer(3, GL_FLOAT, sizeof(DrawnCorner), offset(offsetof(DrawnCorner, position)));
	glNormalPointer(GL_FLOAT, sizeof(DrawnCorner), offset(offsetof(DrawnCorner, normal)));
	glEnable(GL_DEPTH_TEST);
	glDepthFunc(GL_LEQUAL);
	glDisable(GL_BLEND);
	glDisable(GL_CULL_FACE);
	glDisable(GL_TEXTURE_2D);
	glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
	if (isOverOriginal(choices)) glDepthRange(0, 0.9995);
	if (choices.faces) fillTriangles(choices, cornerNum);
	if (choices.wireframe) outlineTriangles(choices, cornerNum);
	glDepthRange(0, 1);
	sent.buffer.release();
}

void PreviewPainter::draw(const ViewChoices& choices, const float* transform, const QSize& size,
						  const Background& background)
{
	if (!hasResult()) return;
	const KeptState kept;
	QOpenGLContext::currentContext()->functions()->glUseProgram(0);
	glMultMatrixf(transform);
	const int  wipeColumn = int(std::lround(choices.wipeAt * size.width()));
	const bool hasOther   = choices.otherSide == OtherSide::QuadricCollapse && hasQuadric();
	if (choices.isWiped) {
		if (hasOther) {
			restrictTo(0, wipeColumn, size.height());
			clearRestricted(background);
			drawFaces(choices, quadric_);
		}
		restrictTo(wipeColumn, size.width(), size.height());
		clearRestricted(background);
	}
	drawFaces(choices, result_);
	if (choices.isWiped) drawWipeLine(choices.wipeAt);
}

} // namespace gpr_filter
