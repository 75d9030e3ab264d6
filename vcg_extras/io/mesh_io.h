// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_IO_H
#define VCG_EXTRAS_IO_MESH_IO_H

#include <vcg_extras/core/options.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <string>

namespace gpr::app {

enum class MeshFormat { Ply, Obj, Off, Stl, Glb, Gltf, ThreeMf };

/// The extensions that this build reads and writes, as a sentence lists them.
std::string formatNames();

/// The format of a file extension, in upper or lower case. Throws AppError (Usage) for other
/// extensions, and for a format whose library this build lacks.
MeshFormat formatOfPath(const std::string& path);

/// Whether a path has an extension of a mesh that this build writes.
bool isMeshName(const std::string& path);

/// The attributes without which a run with these options cannot be.
WantedAttributes neededBy(const RemeshOptions& options);

/// Reads a mesh in the format of its extension. Throws AppError (BadInput) with a sentence that
/// names the file, if the file cannot be read, has no faces or lacks a wanted attribute, and
/// (Usage) if the format has no such attribute.
InputMesh readMesh(const std::string& path, const WantedAttributes& wanted = {});

/// Adds words to attributes.lost for data that only other formats hold. For files of other writers
/// than writeMesh, such as levels in GLB.
void tellLost(MeshFormat format, MeshAttributes& attributes);

/// The name of a format that holds floats only; empty for all other formats.
std::string nameOfFloatFormat(MeshFormat format);

/// Throws AppError (PromiseBroken) if a mesh in double goes to a format that holds floats only, and
/// floats would spoil faces: facesSpoiledByFloat.
void requireFaces(const TriangleMesh& mesh, bool doublePrecision, const std::string& path);

/// Writes a mesh in the format of the path's extension, and finishes the file. Throws AppError
/// (Failure) if writing fails, and as requireFaces. Throws (Stopped) if the run has to end.
/// attributes.lost receives words for data that the format does not hold.
void writeMesh(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
			   OutputFile& out);

/// The same, and puts the file in its place; an older file is replaced only after success.
void writeMesh(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
			   const std::string& path, const RunLimit& limit);

} // namespace gpr::app

#endif
