// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_EDIT_SESSION_H
#define FILTER_GEODESIC_POISSON_EDIT_SESSION_H

#include "edit_api.h"
#include "parameter_bridge.h"
#include "preview_painter.h"
#include "preview_worker.h"
#include "remesh_panel.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <memory>

class QMouseEvent;

namespace gpr_filter {

/// The memory of a tool from one use to the next.
struct EditMemory {
	PanelValues values;                      ///< values changed by the user
	int         layerId = -1, vertexNum = 0; ///< of the layer of the sizes
	ViewChoices choices;
};

/// One use of the edit tool: from the press on its icon to the next press, or to Apply. The session
/// joins panel, worker and painter; all calls come from the window's thread.
class EditSession : public QObject {
	Q_OBJECT

public:
	/// Copies the layer and shows the panel. The memory must outlive this.
	EditSession(MeshDocument& document, MeshModel& layer, GLArea& view,
				MLSceneGLSharedDataContext& context, EditMemory& memory);
	/// Ends a run under way; the layer is shown as before.
	~EditSession() override;

	/// To be called if the view goes first: view and document are then not touched any more.
	void forgetView() { isViewGone_ = true; }

	void draw();
	void mousePressEvent(QMouseEvent& event);
	void mouseMoveEvent(QMouseEvent& event);
	void mouseReleaseEvent(QMouseEvent& event);
	/// The view's own doing, as if no tool were open.
	void passOn(QEvent& event);

private:
	MeshDocument&                  document_;
	int                            layerId_;
	GLArea&                        view_;
	MLSceneGLSharedDataContext&    context_;
	EditMemory&                    memory_;
	gpr::MeshFacts                 facts_;
	QPointer<RemeshPanel>          panel_;
	std::unique_ptr<PreviewWorker> worker_;
	PreviewPainter                 painter_;
	QTimer                         rest_, flight_, watch_;
	QElapsedTimer                  sinceChange_, sinceBeat_;
	std::uint64_t                  lastRequest_  = 0;
	std::uint64_t                  drawnRequest_ = 0;
	std::shared_ptr<const Preview> shown_;
	gpr::RemeshOptions             copiedFor_;               ///< the options of the worker's copy
	RegionSource     copiedRegions_ = RegionSource::Nothing; ///< the regions of the worker's copy
	bool             isApplying_ = false, isWiping_ = false, isViewGone_ = false;
	bool             isDraftDone_ = true, isFullUnderWay_ = false; ///< of the last request
	vcg::Similarityf flightStart_, flightEnd_;
	int              flightStep_ = 0;

	MeshModel*     layer();
	ReadParameters wantedParameters(bool isDraft);
	void           request(bool isDraft);
	void           requestFull();
	void           endDraft();
	void           requestQuadric();
	void           copyMarksFor(const ReadParameters& read, const gpr::RemeshOptions& options);
	void           changeValues();
	void           rememberValues();
	void           changeChoices();
	void           takeNews();
	void           showPreview(std::shared_ptr<const Preview> preview);
	bool           isUpToDate() const;
	void           apply();
	void           finishApply();
	void           putResult();
	void           tell(const std::vector<std::string>& lines);
	void           leave();
	void           flyTo(const Spot& spot);
	void           fly();
	void           hideOriginal(bool isHidden);
	bool           isAtWipeLine(const QMouseEvent& event) const;
	void           watchForStalls();
};

} // namespace gpr_filter

#endif
