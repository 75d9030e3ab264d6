// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every option of the engine is reached through the templates: each row of the parameter table is
// stored into a template's parameters by its key. The result must have the bytes of the facade,
// called with the options of gpr::ParameterSet for the same values.
#include "option_support.h"
#include "poisson_samples.h"

#include <vcg_extras/complex/algorithms/feature_detection.h>
#include <vcg_extras/complex/algorithms/geodesic_poisson_remeshing.h>
#include <vcg_extras/complex/algorithms/geodesic_poisson_sampling.h>
#include <vcg_extras/complex/algorithms/retriangulation.h>

#include <algorithm>
#include <set>
#include <type_traits>

using namespace gpr_test;
using namespace vcg::tri;

namespace {

typedef FullMesh<float> AnyMesh;
static_assert(
	std::is_base_of<gpr::RemeshOptions, GeodesicPoissonRemeshing<AnyMesh>::Params>::value);
static_assert(std::is_base_of<gpr::RemeshOptions, GeodesicPoissonSampling<AnyMesh>::Params>::value);
static_assert(std::is_base_of<gpr::RemeshOptions, Retriangulation<AnyMesh>::Params>::value);
static_assert(std::is_base_of<gpr::RemeshOptions, FeatureDetection<AnyMesh>::Params>::value);

/// A tool by its template and by the facade of the engine.
template <class MeshType>
struct RemeshingTool {
	typedef GeodesicPoissonRemeshing<MeshType> Algorithm;
	typedef typename Algorithm::Params         Params;

	static OptionOutcome ByTemplate(MeshType& m, const Params& params)
	{
		MeshType      out;
		OptionOutcome outcome = OutcomeOf(Algorithm::Do(m, out, params));
		AddMesh(out, outcome);
		return outcome;
	}
	static OptionOutcome ByFacade(MeshType& m, const gpr::RemeshOptions& options)
	{
		const OptionInput       input   = InputOf(m);
		const gpr::RemeshResult run     = gpr::remesh(input.View(options), options);
		OptionOutcome           outcome = OutcomeOf(run);
		AddPositions<typename MeshType::ScalarType>(run.mesh.positions, outcome);
		outcome.indices.assign(run.mesh.triangles.begin(), run.mesh.triangles.end());
		return outcome;
	}
};

template <class MeshType>
struct SamplingTool {
	typedef GeodesicPoissonSampling<MeshType> Algorithm;
	typedef typename Algorithm::Params        Params;

	static OptionOutcome ByTemplate(MeshType& m, const Params& params)
	{
		MeshType      points;
		OptionOutcome outcome = OutcomeOf(Algorithm::Sample(m, params, points));
		AddMesh(points, outcome);
		for (const auto& v : points.vert)
			outcome.numbers.push_back(double(v.cQ()));
		return outcome;
	}
	static OptionOutcome ByFacade(MeshType& m, const gpr::RemeshOptions& options)
	{
		typedef typename MeshType::ScalarType ScalarType;
		const OptionInput                     input = InputOf(m);
		const gpr::SamplingResult run     = gpr::samplePoissonDisks(input.View(options), options);
		OptionOutcome             outcome = OutcomeOf(run);
		AddPositions<ScalarType>(run.points, outcome);
		for (const double radius : run.radii)
			outcome.numbers.push_back(double(ScalarType(radius)));
		return outcome;
	}
};

template <class MeshType>
struct RetriangulationTool {
	typedef Retriangulation<MeshType>  Algorithm;
	typedef typename Algorithm::Params Params;

	static OptionOutcome ByTemplate(MeshType& m, const Params& params)
	{
		MeshType      out;
		OptionOutcome outcome = OutcomeOf(Algorithm::Do(m, PoissonSamples(m, 400), out, params));
		AddMesh(out, outcome);
		return outcome;
	}
	static OptionOutcome ByFacade(MeshType& m, const gpr::RemeshOptions& options)
	{
		std::vector<gpr::Vec3d> samples;
		for (const auto& p : PoissonSamples(m, 400))
			samples.push_back({double(p[0]), double(p[1]), double(p[2])});
		const OptionInput       input   = InputOf(m);
		const gpr::RemeshResult run     = gpr::retriangulate(input.View(options), samples, options);
		OptionOutcome           outcome = OutcomeOf(run);
		AddPositions<typename MeshType::ScalarType>(run.mesh.positions, outcome);
		outcome.indices.assign(run.mesh.triangles.begin(), run.mesh.triangles.end());
		return outcome;
	}
};

template <class MeshType>
struct DetectionTool {
	typedef FeatureDetection<MeshType> Algorithm;
	typedef typename Algorithm::Params Params;

	/// In the engine's numbering: without deleted vertices.
	static OptionOutcome ByTemplate(MeshType& m, const Params& params)
	{
		typename Algorithm::Features features;
		OptionOutcome                outcome = OutcomeOf(Algorithm::Detect(m, features, params));
		std::vector<std::int64_t>    indexOf;
		std::int64_t                 liveNum = 0;
		for (std::size_t v = 0; v < features.vertexStrength.size(); ++v) {
			indexOf.push_back(liveNum);
			if (m.vert[v].IsD()) continue;
			++liveNum;
			outcome.numbers.push_back(double(features.vertexStrength[v]));
			outcome.indices.push_back(features.vertexFeature[v]);
		}
		for (const auto& e : features.edges)
			for (const auto* v : e.v)
				outcome.indices.push_back(indexOf[Index(m, v)]);
		return outcome;
	}
	static OptionOutcome ByFacade(MeshType& m, const gpr::RemeshOptions& options)
	{
		const OptionInput        input   = InputOf(m);
		const gpr::FeatureResult run     = gpr::detectFeatures(input.View(options), options);
		OptionOutcome            outcome = OutcomeOf(run);
		outcome.numbers.assign(run.vertexStrength.begin(), run.vertexStrength.end());
		outcome.indices.assign(run.vertexFeature.begin(), run.vertexFeature.end());
		for (const gpr::FeatureEdge& e : run.edges)
			outcome.indices.insert(outcome.indices.end(), {e.vertex[0], e.vertex[1]});
		return outcome;
	}
};

/// Common values of all trials: with these values most rows have an effect.
const OptionValues& CommonValues()
{
	static const OptionValues values = {{"TargetVertexNum", std::int64_t(300)},
										{"Features", std::int64_t(1)},
										{"FeatureRegion", std::int64_t(1)},
										{"Lambda", 1.0}};
	return values;
}

/// The other values of a trial of a row. Without feature lines, sizes follow the error.
OptionValues ValuesBeside(const std::string& key)
{
	OptionValues values = CommonValues();
	if (key == "Adapt") values["Features"] = std::int64_t(gpr::FeatureMode::Off);
	if (key == "RelaxIter" || key == "FlipIter")
		values["Preset"] = std::int64_t(gpr::Preset::Paper);
	return values;
}

/// Values of a row beside its default, some of which the engine may refuse.
std::vector<gpr::ParameterValue> OtherValues(const gpr::Parameter& row)
{
	const gpr::ParameterValue        usual = row.defaultValue(gpr::MeshFacts());
	std::vector<gpr::ParameterValue> others;
	switch (row.kind) {
	case gpr::ParameterKind::Switch:
		others.push_back(!std::get<bool>(usual));
		break;
	case gpr::ParameterKind::Choice:
		for (std::size_t i = 0; i < row.choices.size(); ++i)
			if (std::int64_t(i) != std::get<std::int64_t>(usual)) others.push_back(std::int64_t(i));
		break;
	case gpr::ParameterKind::Count:
		others = {std::int64_t(25)};
		if (std::string(row.key) != "Seed") // 0 is another seed each time
			others.push_back(std::int64_t(row.minimum));
		break;
	case gpr::ParameterKind::Length:
		others.push_back(0.1);
		break;
	case gpr::ParameterKind::Number:
		const double number = row.isAutomatic ? 0 : std::get<double>(usual);
		if (number > 0)
			others = {0.25 * number, 0.8 * number, 0.5 * (number + row.maximum)};
		else
			others = {std::min(50.0, row.maximum)};
		break;
	}
	return others;
}

/// The values stored into a template's parameters, each by its key.
template <class ParamsType>
ParamsType ParamsOf(const OptionValues& values, gpr::TargetMode targetMode)
{
	ParamsType params;
	for (const auto& [key, value] : values)
		gpr::findParameter(key)->store(value, params);
	params.targetMode = targetMode;
	return params;
}

/// Rows whose other values are refused for the test mesh, which is not symmetric.
bool IsRefusedForTheMesh(const std::string& key)
{
	return key == "Symmetry";
}

/// Compares template and facade for the values of a row. Returns whether a value changes the mesh.
template <class ToolType, class MeshType>
bool ExpectFacadesBytes(const gpr::Parameter& row)
{
	MeshType m;
	MakeOptionMesh(m);
	const OptionValues  beside = ValuesBeside(row.key);
	const OptionOutcome usual  = ToolType::ByFacade(m, SetOf(beside).options());
	EXPECT_EQ(usual.status, gpr::Status::Ok) << usual.message;
	bool isTaken = false, hasEffect = false;
	for (const gpr::ParameterValue& value : OtherValues(row)) {
		OptionValues values              = beside;
		values[row.key]                  = value;
		const gpr::RemeshOptions options = SetOf(values).options();
		const auto params = ParamsOf<typename ToolType::Params>(values, options.targetMode);
		const OptionOutcome byFacade = ToolType::ByFacade(m, options);
		EXPECT_EQ(ToolType::ByTemplate(m, params), byFacade);
		const bool isOk  = byFacade.status == gpr::Status::Ok;
		const bool isFor = isOk != IsRefusedForTheMesh(row.key);
		isTaken          = isTaken || isFor;
		hasEffect        = hasEffect || (isFor && !byFacade.SameMesh(usual));
	}
	EXPECT_TRUE(isTaken) << "no value of the row is of use here";
	return hasEffect;
}

/// Rows without an effect on the mesh: a mesh or none, and speed; also sewing and junctions, since
/// the mesh has no seams and is manifold.
bool LeavesMeshAlone(const std::string& key)
{
	static const std::set<std::string> keys = {"AllowNearest", "Check",   "Junctions",
											   "SewSeams",     "Threads", "TimeLimit"};
	return keys.count(key) > 0;
}

/// The keys of the rows of a tool.
std::vector<std::string> KeysOf(gpr::Tool tool)
{
	std::vector<std::string> keys;
	for (const gpr::Parameter& row : gpr::parametersOf(tool))
		keys.push_back(row.key);
	return keys;
}

std::string KeyOf(const ::testing::TestParamInfo<std::string>& info)
{
	return info.param;
}

class RemeshingOption : public ::testing::TestWithParam<std::string> {};
class SamplingOption : public ::testing::TestWithParam<std::string> {};
class RetriangulationOption : public ::testing::TestWithParam<std::string> {};
class DetectionOption : public ::testing::TestWithParam<std::string> {};

template <template <class> class ToolType>
void ExpectReached(const std::string& key)
{
	const gpr::Parameter& row = *gpr::findParameter(key);
	for (const bool hasEffect :
		 {ExpectFacadesBytes<ToolType<FullMesh<float>>, FullMesh<float>>(row),
		  ExpectFacadesBytes<ToolType<FullMesh<double>>, FullMesh<double>>(row)})
		EXPECT_NE(hasEffect, LeavesMeshAlone(key)) << "the test would not see it missing";
}

TEST_P(RemeshingOption, IsReached)
{
	ExpectReached<RemeshingTool>(GetParam());
}
TEST_P(SamplingOption, IsReached)
{
	ExpectReached<SamplingTool>(GetParam());
}
TEST_P(RetriangulationOption, IsReached)
{
	ExpectReached<RetriangulationTool>(GetParam());
}
TEST_P(DetectionOption, IsReached)
{
	ExpectReached<DetectionTool>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Table, RemeshingOption, ::testing::ValuesIn(KeysOf(gpr::RemeshTool)),
						 KeyOf);
INSTANTIATE_TEST_SUITE_P(Table, SamplingOption, ::testing::ValuesIn(KeysOf(gpr::SamplingTool)),
						 KeyOf);
INSTANTIATE_TEST_SUITE_P(Table, RetriangulationOption,
						 ::testing::ValuesIn(KeysOf(gpr::RetriangulateTool)), KeyOf);
INSTANTIATE_TEST_SUITE_P(Table, DetectionOption, ::testing::ValuesIn(KeysOf(gpr::FeatureTool)),
						 KeyOf);

template <class S>
class Params : public ::testing::Test {
};
TYPED_TEST_SUITE(Params, Scalars);

TYPED_TEST(Params, ARegionMayBeSelectedByItsFaces)
{
	typedef FullMesh<TypeParam>     MeshType;
	typedef RemeshingTool<MeshType> ToolType;
	MeshType                        m;
	MakeOptionMesh(m);
	typename ToolType::Params params;
	params.featureRegion = gpr::FeatureRegion::Selection;
	for (auto& v : m.vert)
		v.ClearS();
	for (auto& f : m.face)
		if (f.IsS() && f.cP(0)[0] > 0.5) f.ClearS();
	const OptionOutcome byFaces = ToolType::ByTemplate(m, params);
	ASSERT_EQ(byFaces.status, gpr::Status::Ok) << byFaces.message;
	for (auto& f : m.face)
		for (int k = 0; k < 3; ++k)
			if (!f.IsD() && f.IsS()) f.V(k)->SetS();
	EXPECT_EQ(byFaces, ToolType::ByFacade(m, params)) << "by the corners of these faces";

	for (auto& f : m.face)
		f.SetS();
	EXPECT_EQ(byFaces, ToolType::ByTemplate(m, params)) << "selected vertices come first";
}

TYPED_TEST(Params, WhatTheMeshHasNotIsRefused)
{
	typedef FullMesh<TypeParam> MeshType;
	typedef BareMesh<TypeParam> Bare;
	MeshType                    m;
	Bare                        bare, out;
	MakeTorus(m);
	Append<Bare, MeshType>::Mesh(bare, m);
	const auto before = SnapshotOf(bare);

	typedef typename GeodesicPoissonRemeshing<Bare>::Params ParamsType;
	ParamsType                                              region, edges, faces;
	region.featureRegion = gpr::FeatureRegion::Selection;
	edges.featureMode    = gpr::FeatureMode::Given;
	faces.selectedOnly   = true;
	for (const ParamsType& params : {region, edges, faces}) {
		const auto result = GeodesicPoissonRemeshing<Bare>::Do(bare, params);
		EXPECT_EQ(result.status, gpr::Status::BadOptions);
		EXPECT_FALSE(result.message.empty());
	}
	for (const ParamsType& params : {region, edges})
		EXPECT_EQ(GeodesicPoissonSampling<Bare>::Sample(bare, params, out).status,
				  gpr::Status::BadOptions);
	EXPECT_TRUE(SnapshotOf(bare) == before);
	EXPECT_EQ(out.VN(), 0);
}

TEST(ParamsOfAnyMesh, SettersChooseTheTarget)
{
	GeodesicPoissonRemeshing<AnyMesh>::Params params;
	params.SetTargetLen(0.5);
	EXPECT_EQ(params.targetMode, gpr::TargetMode::EdgeLength);
	EXPECT_EQ(params.targetEdgeLen, 0.5);
	params.SetTargetPerc(20);
	EXPECT_EQ(params.targetMode, gpr::TargetMode::Percent);
	EXPECT_EQ(params.targetPercent, 20);
	params.SetTargetMaxError(0.25);
	EXPECT_EQ(params.targetMode, gpr::TargetMode::MaxError);
	EXPECT_EQ(params.targetMaxError, 0.25);
	params.SetTargetVertexNum(77);
	EXPECT_EQ(params.targetMode, gpr::TargetMode::VertexNum);
	EXPECT_EQ(params.targetVertexNum, 77);
}

TEST(ParamsOfAnyMesh, AreHandedFromOneAlgorithmToAnother)
{
	GeodesicPoissonSampling<AnyMesh>::Params sampling;
	sampling.lambda                                         = 3;
	sampling.threads                                        = 2;
	const Retriangulation<AnyMesh>::Params  retriangulation = sampling;
	const FeatureDetection<AnyMesh>::Params detection       = sampling;
	EXPECT_EQ(retriangulation.lambda, 3);
	EXPECT_EQ(detection.threads, 2);
}

TEST(ParamsOfAnyMesh, ShortNamesOfThresholdsAreOfTheirOwnCopy)
{
	FeatureDetection<AnyMesh>::Params a;
	a.strongAngleDeg = 60;
	a.weakAngleDeg   = 30;
	a.supportRatio   = 1;
	a.minLenRatio    = 5;
	EXPECT_EQ(a.featureThresholds.strongDeg, 60);
	EXPECT_EQ(a.featureThresholds.weakDeg, 30);
	EXPECT_EQ(a.featureThresholds.support, 1);
	EXPECT_EQ(a.featureThresholds.minLength, 5);
	FeatureDetection<AnyMesh>::Params copied = a, assigned;
	assigned                                 = a;
	for (FeatureDetection<AnyMesh>::Params* b : {&copied, &assigned}) {
		EXPECT_EQ(b->strongAngleDeg, 60);
		b->strongAngleDeg = 70;
		EXPECT_EQ(b->featureThresholds.strongDeg, 70);
	}
	EXPECT_EQ(a.strongAngleDeg, 60);
}

} // namespace
