// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_VCG_OPTION_SUPPORT_H
#define GPR_TESTS_VCG_OPTION_SUPPORT_H

// A mesh on which most options have an effect, and calls of the engine without the templates.

#include "support.h"

#include <vcg_extras/core/parameters.h>
#include <vcg_extras/core/remesh.h>

#include <map>
#include <string>

namespace gpr_test {

/// A waved sheet with a border and a crease that fades out, and a small sphere beside the sheet.
/// Some vertices, faces and edges are selected, the quality grows along x, and the vectors have
/// gaps.
template <class MeshType>
void MakeOptionMesh(MeshType& m)
{
	typedef typename MeshType::ScalarType ScalarType;
	typedef typename MeshType::CoordType  CoordType;
	vcg::tri::Grid(m, 41, 41, 2.0f, 2.0f);
	for (auto& v : m.vert) {
		const double x = v.P()[0], y = v.P()[1];
		const double noise = 0.004 * std::sin(70 * x + 90 * y);
		v.P()[2] = ScalarType(std::abs(x - 1) * (1 - y / 2) + 0.1 * std::sin(5 * y) + noise);
		v.Q()    = ScalarType(x);
		if (x < 0.5 && y < 0.5) v.SetS();
	}
	for (auto& f : m.face) {
		if (f.P(0)[0] < 1.3 && f.P(0)[1] < 1.4) f.SetS();
		for (int k = 0; k < 3; ++k)
			if (f.P(k)[1] == 1 && f.P((k + 1) % 3)[1] == 1) f.SetFaceEdgeS(k);
	}
	MeshType sphere;
	MakeSphere(sphere, 0);
	for (auto& v : sphere.vert) {
		v.P() = v.P() * ScalarType(0.3) + CoordType(4, 0, 0);
		v.Q() = 1;
	}
	vcg::tri::Append<MeshType, MeshType>::Mesh(m, sphere);
	AddGaps(m);
}

/// The input of the engine, made without the templates.
struct OptionInput {
	std::vector<gpr::Vec3d>   positions;
	std::vector<std::int32_t> triangles;
	std::vector<std::uint8_t> selected, selectedFace, selectedEdge;

	gpr::MeshView View(const gpr::RemeshOptions& options) const
	{
		gpr::MeshView view(positions, triangles);
		view.selected     = selected.data();
		view.selectedFace = selectedFace.data();
		if (options.featureMode == gpr::FeatureMode::Given) view.line = selectedEdge.data();
		return view;
	}
};

template <class MeshType>
OptionInput InputOf(const MeshType& m)
{
	OptionInput                         input;
	std::map<const void*, std::int32_t> indexOf;
	for (const auto& v : m.vert) {
		if (v.IsD()) continue;
		indexOf[&v] = std::int32_t(input.positions.size());
		input.positions.push_back({double(v.cP()[0]), double(v.cP()[1]), double(v.cP()[2])});
		input.selected.push_back(v.IsS() ? 1 : 0);
	}
	for (const auto& f : m.face) {
		if (f.IsD()) continue;
		input.selectedFace.push_back(f.IsS() ? 1 : 0);
		for (int k = 0; k < 3; ++k) {
			input.triangles.push_back(indexOf.at(f.cV(k)));
			input.selectedEdge.push_back(f.IsFaceEdgeS(k) ? 1 : 0);
		}
	}
	return input;
}

/// A result in numbers, for a comparison bit by bit.
struct OptionOutcome {
	gpr::Status               status = gpr::Status::InternalError;
	std::string               message;
	std::vector<std::string>  notes;
	std::vector<double>       numbers; ///< coordinates, strengths or the like
	std::vector<std::int64_t> indices; ///< of faces, or marks

	bool SameMesh(const OptionOutcome& b) const
	{
		return status == b.status && numbers == b.numbers && indices == b.indices;
	}
	bool operator==(const OptionOutcome& b) const
	{
		return SameMesh(b) && message == b.message && notes == b.notes;
	}
};
inline std::ostream& operator<<(std::ostream& to, const OptionOutcome& o)
{
	return to << gpr::statusName(o.status) << " " << o.message << ", " << o.numbers.size()
			  << " numbers, " << o.indices.size() << " indices";
}

/// Status, message and notes of an engine's or a template's result.
template <class ResultType>
OptionOutcome OutcomeOf(const ResultType& result)
{
	OptionOutcome outcome;
	outcome.status  = result.status;
	outcome.message = result.message;
	outcome.notes   = result.notes;
	return outcome;
}

/// Adds positions, rounded to this scalar.
template <class ScalarType>
void AddPositions(const std::vector<gpr::Vec3d>& positions, OptionOutcome& outcome)
{
	for (const gpr::Vec3d& p : positions)
		for (const double c : {p.x, p.y, p.z})
			outcome.numbers.push_back(double(ScalarType(c)));
}

template <class MeshType>
void AddMesh(const MeshType& m, OptionOutcome& outcome)
{
	for (const auto& v : m.vert)
		for (int k = 0; k < 3; ++k)
			outcome.numbers.push_back(double(v.cP()[k]));
	for (const auto& f : m.face)
		for (int k = 0; k < 3; ++k)
			outcome.indices.push_back(std::int64_t(vcg::tri::Index(m, f.cV(k))));
}

/// Values of rows of the table, by their key.
typedef std::map<std::string, gpr::ParameterValue> OptionValues;

inline gpr::ParameterSet SetOf(const OptionValues& values)
{
	gpr::ParameterSet set;
	for (const auto& [key, value] : values)
		set.set(*gpr::findParameter(key), value);
	return set;
}

} // namespace gpr_test

#endif
