// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_STAGES_H
#define VCG_EXTRAS_CORE_BASE_STAGES_H

#include <cstddef>

namespace gpr {

/// A sequence of stages, in the order of the table: the work of a function of remesh.h.
enum class Pipeline { Remeshing, Sampling, Retriangulation, Detection };
constexpr std::size_t pipelineNum = 4;

/// A step of a pipeline with a time in the report.
enum class Stage {
	Load,
	Sew,
	SplitLongEdges,
	Order,
	Connect,
	Repair,
	Detection,
	Sizing,
	InputFigures,
	FeatureLines,
	Boundary,
	Sampling,
	GivenSamples,
	Retriangulation,
	Flips,
	Count,
	Relaxation,
	Fit,
	Angles,
	Error,
	Contacts,
	Audit,
	Check,
	Export
};

struct StageRow {
	Stage       stage;
	const char* key;    ///< in the report
	const char* phrase; ///< progress text for the user
	/// Per pipeline: the share of work done at the end of the stage; 0: the stage is not in the
	/// pipeline.
	double until[pipelineNum];
};

/// All stages in their order. If a part of the work is repeated, an earlier row may follow a later
/// row; progress then waits. The shares are approximately from a run on a scan of 269,000 faces
/// with default options and a tenth of the vertices.
constexpr StageRow stageTable[] = {
	// clang-format off
	//                                                                                     remeshing, sampling, retriangulation, detection
	{Stage::Load,            "load",            "Copying the mesh",                        {0.05,  0.14,  0.05,  0.03}},
	{Stage::Sew,             "sew",             "Sewing seams",                            {0.051, 0.142, 0.051, 0.031}},
	{Stage::SplitLongEdges,  "splitLongEdges",  "Splitting long edges",                    {0.055, 0.15,  0.06,  0}},
	{Stage::Order,           "order",           "Ordering",                                {0.11,  0.27,  0.12,  0.1}},
	{Stage::Connect,         "connect",         "Connecting",                              {0.18,  0.46,  0.2,   0.22}},
	{Stage::Repair,          "repair",          "Repairing",                               {0.19,  0.47,  0.21,  0.23}},
	{Stage::Detection,       "detection",       "Detecting features",                      {0,     0,     0,     0.95}},
	{Stage::Sizing,          "sizing",          "Computing local sizes",                     {0.2,   0.48,  0.22,  0}},
	{Stage::InputFigures,    "figures",         "Counting",                                {0.205, 0.5,   0.225, 0.97}},
	{Stage::FeatureLines,    "features",        "Finding feature lines",                   {0.21,  0.51,  0,     0}},
	{Stage::Boundary,        "boundary",        "Sampling the curves",                     {0.215, 0.52,  0,     0}},
	{Stage::Sampling,        "sampling",        "Sampling",                                {0.39,  0.97,  0,     0}},
	{Stage::GivenSamples,    "sampling",        "Projecting the samples",                  {0,     0,     0.6,   0}},
	{Stage::Retriangulation, "retriangulation", "Retriangulating",                         {0.43,  0,     0.9,   0}},
	{Stage::Flips,           "flips",           "Flipping edges",                          {0.44,  0,     0.95,  0}},
	{Stage::Count,           "count",           "Reaching the count",                      {0.46,  0,     0,     0}},
	{Stage::Relaxation,      "relaxation",      "Relaxing",                                {0.6,   0,     0,     0}},
	{Stage::Fit,             "fit",             "Fitting to the input",                    {0.96,  0,     0,     0}},
	{Stage::Angles,          "angles",          "Repairing small angles",                  {0.975, 0,     0,     0}},
	{Stage::Error,           "error",           "Measuring the error",                     {0.98,  0,     0,     0}},
	{Stage::Contacts,        "selfIntersections", "Searching self-intersections",          {0.983, 0,     0,     0}},
	{Stage::Audit,           "audit",           "Checking",                                {0.985, 0,     0.98,  0}},
	{Stage::Check,           "check",           "Checking intersections and distances",    {0.995, 0,     0.99,  0}},
	{Stage::Export,          "export",          "Exporting the result",                    {1,     1,     1,     1}},
	// clang-format on
};

constexpr const StageRow& rowOf(Stage stage)
{
	return stageTable[std::size_t(stage)];
}

constexpr double shareAtEnd(Stage stage, Pipeline pipeline)
{
	return rowOf(stage).until[std::size_t(pipeline)];
}

} // namespace gpr

#endif
