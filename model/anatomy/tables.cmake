# SPDX-License-Identifier: Apache-2.0
# Compiles the tables of anatomy in: makes the sources that ANATOMY_TABLES then lists. Edits of them
# are picked up by the next build.
get_filename_component(tables ${CMAKE_CURRENT_LIST_DIR}/../../resources/anatomy ABSOLUTE)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${tables}/names.tsv ${tables}/cells.tsv ${tables}/systems.tsv ${tables}/structures.tsv
  ${tables}/tissue_patterns.tsv ${tables}/supply.tsv ${tables}/sizes.tsv)
file(READ ${tables}/names.tsv SLINE_ANATOMICAL_NAMES)
file(READ ${tables}/cells.tsv SLINE_CELL_NAMES)
file(READ ${tables}/systems.tsv SLINE_ANATOMY_SYSTEMS)
file(READ ${tables}/structures.tsv SLINE_ANATOMY_STRUCTURES)
file(READ ${tables}/tissue_patterns.tsv SLINE_TISSUE_PATTERNS)
file(READ ${tables}/supply.tsv SLINE_SUPPLY)
file(READ ${tables}/sizes.tsv SLINE_SIZES)
set(ANATOMY_TABLES "")
foreach(table names_table systems_table)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${table}.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${table}.cpp @ONLY)
  list(APPEND ANATOMY_TABLES ${CMAKE_CURRENT_BINARY_DIR}/${table}.cpp)
endforeach()
