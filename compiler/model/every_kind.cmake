# Writes the header every_kind.hpp of a floor: the floor's files of the kinds of elements, by the names that the kinds have in
# compiler/model/elements.  cmake -DSOURCE=TREE -DOUTPUT=FOLDER -P every_kind.cmake
file(GLOB kinds RELATIVE ${SOURCE}/compiler/model/elements ${SOURCE}/compiler/model/elements/*.hpp)
set(about_compiler/formulation/elements
"// Forces of every kind of element: apply(work, element) adds them, add_tangents(work, element, elements) adds their
// derivatives, if any, stored_energy(work, element) integrates the elastic law.")
set(about_runtime/judges/elements
"// The judges' elements, with independent laws: apply(at, element, forces) adds forces, shown(at, forces, element,
// quantity, axis) gives outputs by the table of the kind, energy_of(at, element) integrates the elastic law.")
foreach(floor compiler/formulation/elements runtime/judges/elements)
  set(includes "#pragma once\n// Written by compiler/model/every_kind.cmake.\n${about_${floor}}\n\n")
  foreach(kind ${kinds})
    if(EXISTS ${SOURCE}/${floor}/${kind})
      string(APPEND includes "#include \"${floor}/${kind}\"\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${OUTPUT}/${floor}/every_kind.hpp CONTENT "${includes}" @ONLY)
endforeach()
