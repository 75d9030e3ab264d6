// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_REPORT_FEATURES_REPORT_H
#define VCG_EXTRAS_IO_REPORT_FEATURES_REPORT_H

#include <vcg_extras/core/remesh.h>

#include <string>
#include <vector>

namespace gpr::app {

/// All data for the texts about a feature detection.
struct FeaturesRecord {
	std::string              inputPath;
	std::string              outputPath;
	bool                     doublePrecision = false;
	FeatureThresholds        thresholds;
	FeatureFigures           figures;
	RemeshReport             report;
	std::vector<std::string> notes;
};

/// The report as JSON text. The keys are public: they change with a changelog line.
std::string featuresJson(const FeaturesRecord& record);

/// The summary after a run, some lines of text.
std::string featuresText(const FeaturesRecord& record);

} // namespace gpr::app

#endif
