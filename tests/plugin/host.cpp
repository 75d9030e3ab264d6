// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host.h"

#include <QApplication>
#include <QFileInfo>
#include <common/pluginmanager.h>
#include <cstdio>
#include <gtest/gtest.h>
#include <unistd.h>
#include <vcg/complex/algorithms/create/platonic.h>

namespace plugin_test {

namespace {

PluginManager& manager()
{
	// Never destroyed: plugins do not survive the end of QApplication.
	static PluginManager& loaded = *[] {
		auto*             made = new PluginManager;
		RichParameterList globals;
		made->loadPlugins(globals, QFileInfo(GPR_PLUGIN_FILE).absoluteDir());
		return made;
	}();
	return loaded;
}

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

MeshFilterInterface& plugin()
{
	return *manager().stringFilterMap.value("Remeshing: Geodesic Poisson Disk");
}

QAction* remeshAction()
{
	return manager().actionFilterMap.value("Remeshing: Geodesic Poisson Disk");
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
	layer.UpdateBoxAndNormals();
	return layer;
}

MeshModel& addSheet(Document& document)
{
	MeshModel& layer = *document->addNewMesh("", "sheet");
	vcg::tri::Grid(layer.cm, 51, 51, 1.f, 1.f);
	layer.UpdateBoxAndNormals();
	return layer;
}

RichParameterList defaults(Document& document)
{
	RichParameterList list;
	plugin().initParameterSet(remeshAction(), *document, list);
	return list;
}

bool apply(Document& document, const RichParameterList& list, vcg::CallBackPos* progress)
{
	return plugin().applyFilter(remeshAction(), *document, list, progress);
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
