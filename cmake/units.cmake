# Which files are compiled together, as one unit.

# Whether a file includes headers of deal.II, directly or through a header of ours.
function(find_deal_ii_use file result)
  get_property(known GLOBAL PROPERTY "deal_ii_use ${file}")
  if("${known}" STREQUAL "")
    file(STRINGS ${file} lines REGEX "^#include <(deal\\.II|wheelrail)/")
    set(known no)
    foreach(line ${lines})
      string(REGEX REPLACE "^#include <(.*)>.*" "\\1" header ${line})
      if(header MATCHES "^deal\\.II/")
        set(known yes)
      elseif(EXISTS ${PROJECT_SOURCE_DIR}/include/${header})
        find_deal_ii_use(${PROJECT_SOURCE_DIR}/include/${header} inner)
        if(inner)
          set(known yes)
        endif()
      endif()
    endforeach()
    set_property(GLOBAL PROPERTY "deal_ii_use ${file}" ${known})
  endif()
  set(${result} ${known} PARENT_SCOPE)
endfunction()

# The unit of a file: those of one room (or one kind of test) follow each other in units of some 1500 lines; files
# with and without deal.II are kept apart.
function(find_unit file room result)
  find_deal_ii_use(${file} uses_deal_ii)
  if(NOT uses_deal_ii)
    string(APPEND room _plain)
  endif()
  get_property(number GLOBAL PROPERTY "unit_number ${room}")
  get_property(sum GLOBAL PROPERTY "unit_lines ${room}")
  if(NOT number OR sum GREATER 1500)
    math(EXPR number "0${number} + 1")
    set(sum 0)
  endif()
  file(STRINGS ${file} lines)
  list(LENGTH lines lines)
  math(EXPR sum "${sum} + ${lines}")
  set_property(GLOBAL PROPERTY "unit_number ${room}" ${number})
  set_property(GLOBAL PROPERTY "unit_lines ${room}" ${sum})
  set(${result} ${room}_${number} PARENT_SCOPE)
endfunction()

# Writes the source of a program of several tests. Headers come first, outside of all namespaces; each test is a suite,
# of which the main() of the tests runs the one that the program is called by.
function(write_test_unit unit) # files
  set(headers "")
  set(bodies "")
  foreach(file ${ARGN})
    file(STRINGS ${file} lines REGEX "^#include ")
    list(APPEND headers ${lines})
    get_filename_component(name ${file} NAME_WE)
    string(APPEND bodies "BOOST_AUTO_TEST_SUITE(test_${name})\n#include \"${file}\"\nBOOST_AUTO_TEST_SUITE_END()\n")
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(JOIN headers "\n" headers)
  file(CONFIGURE OUTPUT ${unit} @ONLY CONTENT "// Made by CMake (cmake/units.cmake).
@headers@

@bodies@")
endfunction()
