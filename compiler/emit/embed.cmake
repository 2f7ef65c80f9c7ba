# Writes a C++ file that holds the given files as string literals:
#   cmake -DSOURCE= -DOUTPUT= -DFILES=a,b -DHEADER= -DTYPE= -DFUNCTION= -P embed.cmake
# HEADER declares TYPE, a struct of path and text, and FUNCTION, which returns a const std::vector<TYPE>&.
string(REPLACE "," ";" FILES "${FILES}")
set(text "#include \"${HEADER}\"\n\nnamespace mbgen {\n\nconst std::vector<${TYPE}>& ${FUNCTION}() {\n  static const std::vector<${TYPE}> files = {\n")
foreach(file ${FILES})
  file(READ ${SOURCE}/${file} content)
  # Split in pieces: a literal may not be longer than 64 kB on every compiler.
  string(LENGTH "${content}" length)
  string(APPEND text "    {\"${file}\",")
  set(position 0)
  while(position LESS length)
    string(SUBSTRING "${content}" ${position} 8000 piece)
    string(APPEND text "\n     R\"mbgen_raw(${piece})mbgen_raw\"")
    math(EXPR position "${position} + 8000")
  endwhile()
  if(length EQUAL 0)
    string(APPEND text "\"\"")
  endif()
  string(APPEND text "},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace mbgen\n")
file(WRITE ${OUTPUT} "${text}")
