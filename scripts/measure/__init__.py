# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The measurements behind the tables of README.md and vcg_extras/docs; scripts/measure/run starts them."""
