// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_call.h"

#include "python_progress.h"

#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/surface_distance.h>

#include <algorithm>

namespace gpr::python {

namespace {

/// Distances of the points of one surface from another.
struct OneWay {
	DistanceFigures measured;
	DistanceBounds  proven;
};

struct BothWays {
	Status status = Status::Cancelled;
	OneWay aToB, bToA;
};

/// Measures both directions. Throws CancelledError.
void measure(const MeshView& a, const MeshView& b, std::int64_t sampleNum, Workers& workers,
			 BothWays& out)
{
	const MeasuredSurface     ofB(b, workers), ofA(a, ofB, workers);
	const CertificateSettings settings = usualCertificate(measureMesh(a).diagonal);
	out.aToB   = {ofB.from(a, sampleNum, workers), certifiedDistance(ofA, ofB, settings, workers)};
	out.bToA   = {ofA.from(b, sampleNum, workers), certifiedDistance(ofB, ofA, settings, workers)};
	out.status = Status::Ok;
}

/// The figures of a direction. The proof may find farther points than the samples.
nb::dict figuresOf(const OneWay& way)
{
	nb::dict figures;
	figures["rms"]     = way.measured.rms;
	figures["mean"]    = way.measured.mean;
	figures["p999"]    = way.measured.p999;
	figures["largest"] = std::max(way.measured.max, way.proven.lower);
	figures["lower"]   = way.proven.lower;
	figures["upper"]   = way.proven.upper;
	return figures;
}

} // namespace

nb::dict measureDistance(const Positions& positionsOfA, const Triangles& trianglesOfA,
						 const Positions& positionsOfB, const Triangles& trianglesOfB,
						 std::int64_t sampleNum, int threads, nb::object progress)
{
	const MeshView a = viewOf(positionsOfA, trianglesOfA), b = viewOf(positionsOfB, trianglesOfB);
	if (sampleNum == 0) sampleNum = distanceSampleNum(b.faceNum);
	PythonProgress watch(std::move(progress));
	BothWays       out;
	try {
		const nb::gil_scoped_release noLock;
		Workers                      workers(threads, watch.callback());
		measure(a, b, sampleNum, workers, out);
	}
	catch (const CancelledError&) {
		watch.rethrow();
	}
	nb::dict dict;
	dict["status"]  = statusName(out.status);
	dict["message"] = out.status == Status::Ok ? "" : "Cancelled.";
	dict["a_to_b"]  = figuresOf(out.aToB);
	dict["b_to_a"]  = figuresOf(out.bToA);
	return dict;
}

} // namespace gpr::python
