# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For src/external of MeshLab: the engine of filter_geodesic_poisson.

option(MESHLAB_ALLOW_DOWNLOAD_SOURCE_GPREMESH "Allow download and use of gpremesh source" ON)

if(MESHLAB_ALLOW_DOWNLOAD_SOURCE_GPREMESH)
	set(GPREMESH_DIR "${MESHLAB_EXTERNAL_DOWNLOAD_DIR}/gpremesh-@version@")
	set(GPREMESH_CHECK "${GPREMESH_DIR}/vcg_extras/core/remesh.h")

	if(NOT EXISTS "${GPREMESH_CHECK}")
		download_and_unzip(
			NAME "gpremesh"
			LINK "@archive_url@"
			MD5 "@md5@"
			DIR ${MESHLAB_EXTERNAL_DOWNLOAD_DIR})
		if(NOT download_and_unzip_SUCCESS)
			message(STATUS "- gpremesh - download failed.")
		endif()
	endif()

	if(EXISTS "${GPREMESH_CHECK}")
		message(STATUS "- gpremesh - using downloaded source")
		add_library(external-gpremesh INTERFACE)
		target_include_directories(external-gpremesh INTERFACE "${GPREMESH_DIR}")
	endif()
endif()
