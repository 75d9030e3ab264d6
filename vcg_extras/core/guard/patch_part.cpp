// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_part.h"

#include "face_sets.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cstddef>

namespace gpr {

namespace {

/// Rings of faces cut out round a patch, and how many of these rings the refill looks at; the rest
/// is room to grow.
constexpr int ringsOfPart = 8, ringsLooked = 5;
/// New faces of a patch must not touch faces nearer to the patch than this, in edges.
constexpr float nearPatch = 0.5f;

/// Faces of the whole near some faces, without faces of the part.
std::vector<int> facesNear(const ResultMesh& whole, const FaceBoxes& tree,
						   const std::vector<int>& faces, const std::vector<int>& ofPart,
						   Workers& workers)
{
	const float      distance = nearPatch * whole.idealEdge;
	const Vec3f      margin(distance, distance, distance);
	std::vector<int> found;
	for (int f : faces) {
		workers.poll();
		const Box<float> box = boxOfFace(whole.mesh, f);
		tree.forEachMeeting({box.low - margin, box.high + margin}, [&](int place) {
			const int g = tree.face(place);
			if (placeIn(ofPart, g) < 0) found.push_back(g);
			return true;
		});
	}
	sortUnique(found);
	return found;
}

/// Makes the mesh of a part from the names of its faces; only the first partNum faces are
/// connected.
class PartMesh {
public:
	PartMesh(const ResultMesh& whole, int partNum, PatchPart& part) :
			whole_(whole), own_(part.face.begin(), part.face.begin() + partNum), part_(part),
			m_(part.result.mesh)
	{
	}

	void run()
	{
		m_.mirrorAxis    = whole_.mesh.mirrorAxis;
		m_.faceNum       = int(part_.face.size());
		m_.meetsAtPlaces = whole_.mesh.meetsAtPlaces;
		reserve(m_, m_.halfEdgeNum(), m_.faceNum);
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			m_.origin[h]   = -1;
			m_.opposite[h] = oppositeOf(h);
		}
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			if (m_.origin[h] < 0) addVertex(h);
		}
		if (!whole_.mesh.hasCreases()) return;
		m_.crease.reset(m_.halfEdgeNum());
		for (int h = 0; h < m_.halfEdgeNum(); ++h)
			m_.crease[h] = whole_.mesh.crease[inWhole(h)];
	}

private:
	const ResultMesh&      whole_;
	const std::vector<int> own_;
	PatchPart&             part_;
	HalfEdgeMesh&          m_;

	int inWhole(int h) const { return 3 * part_.face[h / 3] + h % 3; }

	int oppositeOf(int h) const
	{
		const int other = whole_.mesh.opposite[inWhole(h)];
		if (h >= 3 * int(own_.size()) || other < 0) return -1;
		const int place = placeIn(own_, other / 3);
		return place < 0 ? -1 : 3 * place + other % 3;
	}

	/// Adds a vertex for a fan of connected faces.
	void addVertex(int h)
	{
		const int v = m_.vertexNum++, old = whole_.mesh.origin[inWhole(h)];
		int       first = h;
		for (int g = m_.opposite[h]; g >= 0 && nextInFace(g) != h; g = m_.opposite[first])
			first = nextInFace(g);
		m_.outgoing[v] = first;
		m_.position[v] = whole_.mesh.position[old];
		forEachOutgoing(m_, v, [&](int g) { m_.origin[g] = v; });
		part_.vertex.push_back(old);
		part_.result.vertex.push_back(whole_.vertex[old]);
	}
};

} // namespace

bool PatchPart::hasRoomFor(const std::vector<char>& marked) const
{
	const std::vector<int> faces = widened(result.mesh, markedFaces(marked), ringsLooked);
	return std::none_of(faces.begin(), faces.end(), [&](int f) { return isRim[f] != 0; });
}

std::vector<int> PatchPart::inWhole(const std::vector<char>& marked) const
{
	std::vector<int> faces;
	for (int f : markedFaces(marked))
		faces.push_back(face[f]);
	std::sort(faces.begin(), faces.end());
	return faces;
}

PatchPart cutPart(const ResultMesh& whole, const FaceBoxes& tree, const std::vector<int>& faces,
				  int triesBefore, Workers& workers)
{
	PatchPart              part;
	const int              rings = ringsOfPart * (1 + triesBefore);
	const std::vector<int> inner = widened(whole.mesh, faces, rings - 1);
	part.face                    = widened(whole.mesh, inner, 1);
	const int  partNum           = int(part.face.size());
	const auto near =
		facesNear(whole, tree, widened(whole.mesh, faces, ringsChanged), part.face, workers);
	part.face.insert(part.face.end(), near.begin(), near.end());
	workers.poll();
	PartMesh(whole, partNum, part).run();
	for (std::size_t f = 0; f < part.face.size(); ++f) {
		const bool isInner = std::binary_search(inner.begin(), inner.end(), part.face[f]);
		part.isRim.push_back(int(f) < partNum && !isInner);
	}
	static_cast<ResultFacts&>(part.result) = whole;
	return part;
}

namespace {

/// Assembles the whole from its remaining faces and the filled patches.
class Assembly {
public:
	Assembly(const std::vector<FilledPart>& parts, ResultMesh& whole, std::vector<int>& newIndex) :
			parts_(parts), whole_(whole), newIndex_(newIndex),
			newFace_(std::size_t(whole.mesh.faceNum), 0)
	{
	}

	void run()
	{
		const HalfEdgeMesh& old = whole_.mesh;
		m_.mirrorAxis           = old.mirrorAxis;
		m_.meetsAtPlaces        = old.meetsAtPlaces;
		nameVertices();
		for (const FilledPart& part : parts_) {
			for (int f : part.replaced)
				newFace_[f] = -1;
		}
		for (int& name : newFace_)
			name = name < 0 ? -1 : m_.faceNum++;
		for (const FilledPart& part : parts_)
			nameFaces(part);
		reserve(m_, m_.vertexNum, m_.faceNum);
		if (old.hasCreases()) m_.crease.reset(m_.halfEdgeNum());
		add(old, whole_.vertex, newIndex_, newFace_, [](int) { return -1; });
		for (std::size_t i = 0; i < parts_.size(); ++i) {
			const FilledPart& p = parts_[i];
			add(p.filled.mesh, p.filled.vertex, vertexName_[i], faceName_[i],
				[&](int h) { return renamed(oldHalfEdge(p, h)); });
		}
		link();
		whole_.mesh   = std::move(m_);
		whole_.vertex = std::move(vertex_);
	}

private:
	const std::vector<FilledPart>& parts_;
	ResultMesh&                    whole_;
	std::vector<int>&              newIndex_;
	std::vector<int>               newFace_;              ///< per face of the whole: new name, or
														  ///< -1
	std::vector<std::vector<int>> vertexName_, faceName_; ///< per part: new names of filled
														  ///< vertices and faces
	HalfEdgeMesh              m_;
	std::vector<ResultVertex> vertex_;

	int renamed(int h) const
	{
		const int f = newFace_[h / 3];
		return f < 0 ? -1 : 3 * f + h % 3;
	}

	/// Vertices of a patch that no filled face has are gone.
	void nameVertices()
	{
		newIndex_.assign(std::size_t(whole_.mesh.vertexNum), 0);
		for (const FilledPart& part : parts_) {
			std::vector<char> isLeft(part.part.vertex.size(), 0);
			for (int v : part.filled.oldVertex) {
				if (v >= 0) isLeft[v] = 1;
			}
			for (std::size_t v = 0; v < isLeft.size(); ++v) {
				if (!isLeft[v]) newIndex_[part.part.vertex[v]] = -1;
			}
		}
		for (int& name : newIndex_)
			name = name < 0 ? -1 : m_.vertexNum++;
		for (const FilledPart& part : parts_) {
			vertexName_.emplace_back();
			for (int v : part.filled.oldVertex) {
				const int old = v < 0 ? -1 : part.part.vertex[v];
				vertexName_.back().push_back(old < 0 ? m_.vertexNum++ : newIndex_[old]);
			}
		}
		vertex_.resize(std::size_t(m_.vertexNum));
	}

	/// The half-edge of the whole with the same corners as half-edge h of a filled mesh, or -1.
	static int oldHalfEdge(const FilledPart& p, int h)
	{
		const HalfEdgeMesh& m   = p.filled.mesh;
		const auto          old = [&](int v) { return p.filled.oldVertex[v]; };
		const int           a = old(m.origin[h]), b = old(m.target(h)), c = old(m.apex(h));
		if (a < 0 || b < 0 || c < 0) return -1;
		const int g = p.part.result.mesh.findHalfEdge(a, b);
		if (g < 0 || p.part.result.mesh.apex(g) != c) return -1;
		return 3 * p.part.face[g / 3] + g % 3;
	}

	/// Faces of the whole that remain get no name here.
	void nameFaces(const FilledPart& p)
	{
		faceName_.emplace_back();
		for (int f = 0; f < p.filled.mesh.faceNum; ++f) {
			const int  old = oldHalfEdge(p, 3 * f);
			const bool isLeft =
				old >= 0 && !std::binary_search(p.replaced.begin(), p.replaced.end(), old / 3);
			faceName_.back().push_back(isLeft ? -1 : m_.faceNum++);
		}
	}

	/// Adds the faces that have a name. elsewhere(h): the new name of a half-edge of another face,
	/// or -1 if the part with this half-edge follows.
	template <class Elsewhere>
	void add(const HalfEdgeMesh& from, const std::vector<ResultVertex>& vertex,
			 const std::vector<int>& vertexName, const std::vector<int>& faceName,
			 const Elsewhere& elsewhere)
	{
		for (int h = 0; h < from.halfEdgeNum(); ++h) {
			const int f = faceName[h / 3];
			if (f < 0) continue;
			const int to = 3 * f + h % 3, v = from.origin[h], name = vertexName[v];
			m_.origin[to] = name;
			if (m_.hasCreases()) m_.crease[to] = from.isCreaseEdge(h);
			m_.position[name] = from.position[v];
			vertex_[name]     = vertex[v];
			m_.opposite[to]   = -1;
			const int g       = from.opposite[h];
			if (g < 0) continue;
			const int across = faceName[g / 3];
			m_.opposite[to]  = across < 0 ? elsewhere(g) : 3 * across + g % 3;
			if (m_.opposite[to] >= 0) m_.opposite[m_.opposite[to]] = to;
		}
	}

	void link()
	{
		for (int v = 0; v < m_.vertexNum; ++v)
			m_.outgoing[v] = -1;
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			int& outgoing = m_.outgoing[m_.origin[h]];
			if (outgoing < 0 || m_.opposite[h] < 0) outgoing = h;
		}
	}
};

} // namespace

void putBack(const std::vector<FilledPart>& parts, ResultMesh& whole, std::vector<int>& newIndex)
{
	Assembly(parts, whole, newIndex).run();
}

} // namespace gpr
