// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host.h"

#include "filter_text.h"

#include <QApplication>
#include <cstdio>
#include <gtest/gtest.h>
#include <unistd.h>
#include <vcg/complex/algorithms/create/platonic.h>

namespace plugin_test {

namespace {

QString lastError;

std::function<bool(int)> duringRun;

bool callDuringRun(const int percent, const char*)
{
	return duringRun(percent);
}

unsigned char level(float p)
{
	return static_cast<unsigned char>(128 + 100 * p);
}

} // namespace

PluginInterface& plugin()
{
	return loadedPlugin();
}

QAction* actionOf(gpr_filter::Filter filter)
{
	return loadedAction(gpr_filter::textOf(filter).name);
}

Document::Document()
{
	plugin().setLog(&_document.Log);
}

Document::~Document()
{
	plugin().setLog(nullptr);
}

QString Document::logText() const
{
	QStringList lines;
	_document.Log.print(lines);
	return lines.join('\n');
}

MeshModel& addBall(Document& document)
{
	MeshModel& layer = *document->addNewMesh("", "ball.of.wool.ply");
	vcg::tri::Sphere(layer.cm, 5);
	layer.updateDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY);
	for (CVertexO& v : layer.cm.vert) {
		v.C() = vcg::Color4b(level(v.P()[0]), level(v.P()[1]), level(v.P()[2]), 255);
		v.Q() = v.P()[2];
	}
	gpr_filter::updateBoxAndNormals(layer);
	return layer;
}

MeshModel& addSheet(Document& document)
{
	MeshModel& layer = *document->addNewMesh("", "sheet");
	vcg::tri::Grid(layer.cm, 51, 51, 1.f, 1.f);
	gpr_filter::updateBoxAndNormals(layer);
	return layer;
}

MeshModel& addPoints(Document& document, const std::vector<gpr::Vec3d>& points)
{
	MeshModel& layer = *document->addNewMesh("", "points");
	vcg::tri::Allocator<CMeshO>::AddVertices(layer.cm, points.size());
	for (std::size_t i = 0; i < points.size(); ++i) {
		const gpr::Vec3d& p  = points[i];
		layer.cm.vert[i].P() = Point3m(Scalarm(p.x), Scalarm(p.y), Scalarm(p.z));
	}
	gpr_filter::updateBoxAndNormals(layer);
	return layer;
}

RichParameterList defaults(Document& document, gpr_filter::Filter filter)
{
	return defaultsOf(actionOf(filter), *document);
}

bool apply(Document& document, gpr_filter::Filter filter, const RichParameterList& list,
		   vcg::CallBackPos* progress)
{
	return applyAction(actionOf(filter), *document, list, progress, lastError);
}

QString errorText()
{
	return lastError;
}

bool apply(Document& document, const RichParameterList& list, vcg::CallBackPos* progress)
{
	return apply(document, gpr_filter::RemeshFilter, list, progress);
}

void expectSoundMesh(CMeshO& mesh)
{
	EXPECT_EQ(std::size_t(mesh.vn), mesh.vert.size()) << "deleted vertices are left";
	EXPECT_EQ(std::size_t(mesh.fn), mesh.face.size()) << "deleted faces are left";
	for (const CVertexO& v : mesh.vert) {
		ASSERT_FALSE(v.IsD() || v.IsS());
		ASSERT_GT(v.cN().Norm(), 0.1) << "a vertex normal was not computed";
	}
	Box3m box;
	for (const CFaceO& f : mesh.face) {
		ASSERT_FALSE(f.IsD() || f.IsS() || f.IsF(0) || f.IsF(1) || f.IsF(2));
		ASSERT_NEAR(f.cN().Norm(), 1, 1e-4);
		for (int k = 0; k < 3; ++k) {
			ASSERT_LT(vcg::tri::Index(mesh, f.cV(k)), mesh.vert.size());
			box.Add(f.cP(k));
		}
	}
	EXPECT_EQ(mesh.bbox, box);
	EXPECT_EQ(mesh.svn, 0);
	EXPECT_EQ(mesh.sfn, 0);
}

Snapshot::Snapshot(Document& document) :
		_copy(gpr_filter::copyLayer(document->mm()->cm, {true})), _mask(document->mm()->dataMask()),
		_layers(document.layerNum()), _currentId(document->mm()->id())
{
	for (const CVertexO& v : document->mm()->cm.vert) {
		_colours.push_back(v.cC());
		_qualities.push_back(v.cQ());
	}
}

bool Snapshot::operator==(const Snapshot& o) const
{
	return _copy.sameGeometry(o._copy) && _colours == o._colours && _qualities == o._qualities &&
		   _copy.selected == o._copy.selected && _mask == o._mask && _layers == o._layers &&
		   _currentId == o._currentId;
}

DuringRun::DuringRun(std::function<bool(int)> action)
{
	duringRun = std::move(action);
}

DuringRun::~DuringRun()
{
	duringRun = nullptr;
}

vcg::CallBackPos* DuringRun::callback()
{
	return &callDuringRun;
}

} // namespace plugin_test

int main(int argc, char** argv)
{
	qputenv("QT_QPA_PLATFORM", "offscreen");
	QApplication application(argc, argv);
	testing::InitGoogleTest(&argc, argv);
	const int outcome = RUN_ALL_TESTS();
	std::fflush(nullptr);
	// Past MeshLab's static destructors, whose order its own programs do not survive either.
	_exit(outcome);
}
