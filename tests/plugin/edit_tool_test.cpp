// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of the edit tool without a window: its worker, and the commands of its recipe.

#include "edit/preview_worker.h"
#include "edit/recipe.h"
#include "edit/remesh_panel.h"
#include "filter_text.h"
#include "host.h"
#include "layer_job.h"

#include <vcg_extras/core/remesh.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <chrono>
#include <cmath>
#include <common/filterscript.h>
#include <gtest/gtest.h>
#include <thread>

namespace {

using namespace plugin_test;
using gpr_filter::PreviewNews;
using gpr_filter::PreviewRequest;
using gpr_filter::PreviewWorker;
using gpr_filter::Recipe;

using Values = std::map<std::string, gpr::ParameterValue>;

Values someValues()
{
	return {
		{"TargetVertexNum", std::int64_t(700)}, {"Preset", std::int64_t(1)}, {"Lambda", 1.5},
		{"Features", std::int64_t(2)},          {"SewSeams", false},         {"NewLayer", false}};
}

/// A panel for a layer of 5000 vertices, with the actions of a user.
struct Panel {
	gpr_filter::RemeshPanel panel;

	explicit Panel(const Values& values = {}) : panel({5000, 1.0, false}, values, {}, nullptr) {}

	template <class Widget>
	Widget& find(const char* name)
	{
		return *panel.findChild<Widget*>(name);
	}
	QSpinBox&    field() { return find<QSpinBox>("TargetVertexNum"); }
	QSlider&     slider() { return find<QSlider>("TargetVertexNumSlider"); }
	QComboBox&   unit() { return find<QComboBox>("CountUnit"); }
	std::int64_t value(const char* key) { return std::get<std::int64_t>(panel.values().at(key)); }
};

RichParameterList listOf(const QString& script)
{
	const QTemporaryDir folder;
	const QString       path = folder.filePath("recipe.mlx");
	QFile               file(path);
	EXPECT_TRUE(file.open(QIODevice::WriteOnly));
	file.write(script.toUtf8());
	file.close();
	FilterScript read;
	EXPECT_TRUE(read.open(path));
	if (read.size() != 1) {
		ADD_FAILURE() << "the script has " << read.size() << " filters";
		return {};
	}
	EXPECT_EQ(read.at(0).filterName().toStdString(),
			  gpr_filter::textOf(gpr_filter::RemeshFilter).name);
	return read.at(0).second;
}

TEST(Panel, ItsSliderCountsFacesByChoice)
{
	Panel p;
	EXPECT_EQ(p.field().value(), 500);
	const int step = p.slider().value();
	p.unit().setCurrentIndex(1);
	EXPECT_EQ(p.value("TargetFaceNum"), 1000);
	EXPECT_EQ(p.field().value(), 1000);
	EXPECT_EQ(p.slider().value(), step) << "the same size";

	p.slider().setValue(step + 100);
	const std::int64_t faceNum = p.value("TargetFaceNum");
	EXPECT_GT(faceNum, 1000);
	EXPECT_EQ(faceNum % 2, 0) << "closed surfaces have no other";
	EXPECT_EQ(p.field().value(), faceNum);
	p.field().setValue(1024);
	EXPECT_EQ(p.value("TargetFaceNum"), 1024);

	p.unit().setCurrentIndex(0);
	EXPECT_EQ(p.value("TargetFaceNum"), 0);
	EXPECT_EQ(p.value("TargetVertexNum"), 512);
	EXPECT_EQ(p.field().value(), 512);
}

TEST(Panel, AnotherSizeTakesThePlaceOfTheFaces)
{
	Panel p({{"TargetFaceNum", std::int64_t(2000)}});
	EXPECT_EQ(p.unit().currentIndex(), 1) << "as it was left";
	EXPECT_EQ(p.field().value(), 2000);
	p.find<QDoubleSpinBox>("TargetPerc").setValue(20);
	EXPECT_EQ(p.value("TargetFaceNum"), 0);
	EXPECT_EQ(p.unit().currentIndex(), 0);
	p.unit().setCurrentIndex(1);
	EXPECT_EQ(std::get<double>(p.panel.values().at("TargetPerc")), 0);
	EXPECT_GT(p.value("TargetFaceNum"), 0);
}

TEST(Panel, TellsFirstWhatIsCounted)
{
	gpr_filter::Preview preview;
	gpr::RemeshResult   result;
	result.mesh.positions.resize(12);
	result.mesh.triangles.resize(60);
	preview.result = std::make_shared<const gpr::RemeshResult>(result);
	for (const int index : {0, 1}) {
		Panel p;
		p.unit().setCurrentIndex(index);
		p.panel.showFigures(preview, 1);
		const QString first = index == 0 ? "12 vertices, 20 faces" : "20 faces, 12 vertices";
		EXPECT_TRUE(p.find<QLabel>("Figures").text().startsWith(first));
	}
}

TEST(Recipe, TheScriptMakesTheMeshOfTheValues)
{
	Document document;
	addBall(document);
	const gpr::MeshFacts        facts  = gpr_filter::factsOf(*document);
	const gpr_filter::LayerCopy copy   = gpr_filter::copyLayer(document.layer().cm, {});
	const Recipe                recipe = gpr_filter::recipeFor(someValues(), facts, "a/ball.ply");
	gpr::ParameterSet           set;
	for (const auto& [key, value] : someValues()) {
		if (const gpr::Parameter* parameter = gpr::findParameter(key)) // else MeshLab's own
			set.set(*parameter, value);
	}
	const gpr::RemeshResult wanted = gpr::remesh(copy.view(), set.options());
	ASSERT_EQ(wanted.status, gpr::Status::Ok) << wanted.message;

	const RichParameterList list = listOf(recipe.script);
	EXPECT_EQ(list.size(), gpr_filter::rowsOf(gpr_filter::RemeshFilter).size())
		<< "meshlabserver wants all of them";
	ASSERT_TRUE(apply(document, list)) << errorText().toStdString();
	const CMeshO& made = document.layer().cm;
	ASSERT_EQ(std::size_t(made.vn), wanted.mesh.vertexNum());
	for (std::size_t v = 0; v < wanted.mesh.vertexNum(); ++v) {
		const gpr::Vec3d& p = wanted.mesh.positions[v];
		EXPECT_EQ(made.vert[v].cP(),
				  vcg::Point3<Scalarm>(Scalarm(p.x), Scalarm(p.y), Scalarm(p.z)));
	}
}

TEST(Recipe, CommandsNameWhatDiffersFromTheDefaults)
{
	gpr::MeshFacts facts;
	facts.vertexNum     = 1000;
	facts.diagonal      = 2;
	const Recipe recipe = gpr_filter::recipeFor(someValues(), facts, "/of/it's a ball.ply");
	EXPECT_EQ(recipe.command.toStdString(),
			  "gpremesh remesh 'it'\\''s a ball.ply' 'it'\\''s a ball_remeshed.ply' --vertices 700 "
			  "--preset fast --lambda 1.5 --features off --sew off");
	EXPECT_EQ(recipe.python.toStdString(),
			  "meshes.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=700, preset='fast', "
			  "lambda=1.5, features='off', sewseams=False)");
	const Values byLength{{"TargetVertexNum", std::int64_t(700)}, {"TargetLen", 0.125}};
	const Recipe other = gpr_filter::recipeFor(byLength, facts, "ball.ply");
	EXPECT_TRUE(other.command.endsWith("--edge-length 0.125")) << other.command.toStdString();
	EXPECT_TRUE(other.python.endsWith("(targetlen=pymeshlab.PureValue(0.125))"))
		<< other.python.toStdString();
}

/// A proposal for selected vertices is no default of the program's.
TEST(Recipe, TheCommandNamesWhatOnlyMeshLabProposes)
{
	gpr::MeshFacts facts;
	facts.vertexNum           = 1000;
	facts.hasSelectedVertices = true;
	const Recipe recipe       = gpr_filter::recipeFor({}, facts, "ball.ply");
	EXPECT_TRUE(recipe.command.endsWith("--vertices 100 --feature-disk-scale 0.5"))
		<< recipe.command.toStdString();
}

std::shared_ptr<const gpr_filter::LayerCopy> ballCopy()
{
	Document document;
	addBall(document);
	return std::make_shared<const gpr_filter::LayerCopy>(
		gpr_filter::copyLayer(document.layer().cm, {}));
}

PreviewRequest request(std::uint64_t id, std::int64_t vertexNum, bool isDraft)
{
	PreviewRequest wanted;
	wanted.id                      = id;
	wanted.isDraft                 = isDraft;
	wanted.options.targetMode      = gpr::TargetMode::VertexNum;
	wanted.options.targetVertexNum = vertexNum;
	return wanted;
}

/// All news until some pass the test, the last of each kind; gives up after a minute.
template <class Test>
PreviewNews newsUntil(PreviewWorker& worker, const Test& test)
{
	PreviewNews all;
	for (int i = 0; i < 6000 && !test(all); ++i) {
		std::this_thread::sleep_for(std::chrono::milliseconds(10));
		PreviewNews news = worker.takeNews();
		if (news.preview != nullptr) all.preview = news.preview;
		if (news.quadric != nullptr) all.quadric = news.quadric;
		if (!news.failure.empty()) all.failure = news.failure;
	}
	EXPECT_TRUE(test(all));
	return all;
}

TEST(PreviewWorker, MakesDraftsThenMeasuresThenCompares)
{
	const auto    layer = ballCopy();
	PreviewWorker worker(layer);
	worker.request(request(1, 500, true));
	PreviewNews news = newsUntil(worker, [](const PreviewNews& n) { return n.preview != nullptr; });
	EXPECT_EQ(news.preview->request, 1u);
	EXPECT_TRUE(news.preview->isDraft);
	EXPECT_EQ(news.preview->result->mesh.vertexNum(), 500u);
	EXPECT_EQ(news.preview->faces->size(), 3 * news.preview->result->mesh.faceNum());

	worker.request(request(2, 400, false));
	news = newsUntil(
		worker, [](const PreviewNews& n) { return n.preview != nullptr && n.preview->isMeasured; });
	EXPECT_EQ(news.preview->result->mesh.positions,
			  gpr::remesh(layer->view(), request(2, 400, false).options).mesh.positions);
	EXPECT_TRUE(news.preview->worstTriangle.isKnown);
	EXPECT_TRUE(news.preview->farthest.isKnown);
	EXPECT_GT(news.preview->distance.rms, 0);
	EXPECT_GE(news.preview->distance.max, news.preview->distance.p999);
	ASSERT_NE(worker.qualityOfLayer(), nullptr);

	PreviewRequest beside = request(2, 400, false);
	beside.withQuadric = beside.keepsResult = true;
	worker.request(beside);
	news = newsUntil(worker, [](const PreviewNews& n) { return n.quadric != nullptr; });
	EXPECT_EQ(news.preview, nullptr) << "the result is kept";
	EXPECT_NEAR(double(news.quadric->size() / 3), 796, 2);
}

/// Of many requests in a row only the last request surely gets an answer, and no older answer
/// follows.
TEST(PreviewWorker, ANewRequestEndsTheOldOne)
{
	PreviewWorker worker(ballCopy());
	for (std::uint64_t id = 1; id <= 50; ++id) {
		worker.request(request(id, 300 + std::int64_t(10 * id), true));
		if (id % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
	}
	const PreviewNews news = newsUntil(worker, [](const PreviewNews& n) {
		return n.preview != nullptr && n.preview->request == 50;
	});
	EXPECT_EQ(news.preview->result->mesh.vertexNum(), 800u);
}

TEST(PreviewWorker, TellsWhyThereIsNoResultAndGoesOn)
{
	PreviewWorker worker(ballCopy());
	worker.request(request(1, 2, true));
	const PreviewNews failed =
		newsUntil(worker, [](const PreviewNews& n) { return !n.failure.empty(); });
	EXPECT_NE(failed.failure.find("smallest"), std::string::npos) << failed.failure;
	worker.request(request(2, 300, true));
	newsUntil(worker, [](const PreviewNews& n) { return n.preview != nullptr; });
}

template <class Work>
double secondsOf(const Work& work)
{
	const auto start = std::chrono::steady_clock::now();
	work();
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The worker ends amid a run, long before the end of the run.
TEST(PreviewWorker, EndsAmidARun)
{
	const auto           layer = ballCopy();
	const PreviewRequest large = request(1, 30000, false);
	const double         whole = secondsOf([&] { gpr::remesh(layer->view(), large.options); });
	for (int delay : {0, 1, 5, 20, 60}) {
		auto worker = std::make_unique<PreviewWorker>(layer);
		worker->request(large);
		std::this_thread::sleep_for(std::chrono::milliseconds(delay));
		EXPECT_EQ(worker->takeNews().preview, nullptr) << "it is amid the run";
		EXPECT_LT(secondsOf([&] { worker.reset(); }), whole / 2) << "of " << whole << " s";
	}
}

} // namespace
