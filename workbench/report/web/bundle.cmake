# Bundles the page of `mbgen report` and writes a C++ file that holds it:
#   cmake -DMODE=AUTO|ON|OFF -DNODE= -DNPM= -DSOURCE= -DWORK= -DOUTPUT= -DEMBED= -P bundle.cmake
# Without Node.js, npm or the network, AUTO goes on without the page, and `mbgen report` says so; ON stops.
set(embed_arguments -DSOURCE=${WORK} -DOUTPUT=${OUTPUT} -DHEADER=workbench/report/page.hpp -DTYPE=PageFile
  -DFUNCTION=report_page_files)

function(embed files)
  execute_process(COMMAND ${CMAKE_COMMAND} ${embed_arguments} -DFILES=${files} -P ${EMBED} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Ends the script: with an error, or with a file that holds no page.
macro(give_up reason)
  if(MODE STREQUAL "ON")
    message(FATAL_ERROR "mbgen report cannot be built in: ${reason}")
  endif()
  if(MODE STREQUAL "AUTO")
    message("mbgen report is left out: ${reason}")
    message("  to try again: cmake -DMBGEN_REPORTS=ON, and build; to be quiet about it: -DMBGEN_REPORTS=OFF")
  endif()
  embed("")
  return()
endmacro()

# Runs a command in WORK; the end of what it says is the reason when it fails.
macro(run what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} TIMEOUT 300 RESULT_VARIABLE failed
    OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    string(STRIP "${what} failed (${failed}): ${said}" reason)
    give_up("${reason}")
  endif()
endmacro()

if(MODE STREQUAL "OFF")
  give_up("MBGEN_REPORTS is OFF")
endif()
if(NOT NODE OR NOT NPM)
  give_up("node and npm were not found (Debian: apt-get install nodejs npm)")
endif()

file(MAKE_DIRECTORY ${WORK})
file(COPY ${SOURCE}/ DESTINATION ${WORK})
file(SHA256 ${SOURCE}/package-lock.json lock)
set(installed)
if(EXISTS ${WORK}/installed)
  file(READ ${WORK}/installed installed)
endif()
if(NOT installed STREQUAL lock)
  run("npm ci" ${NPM} ci --no-audit --no-fund --loglevel=error)
  file(WRITE ${WORK}/installed ${lock})
endif()
set(esbuild ${WORK}/node_modules/.bin/esbuild --bundle --minify --log-level=warning --legal-comments=eof)
run("esbuild" ${esbuild} src/main.js --format=iife --target=es2020 --outfile=report.js)
run("esbuild" ${esbuild} style.css --outfile=report.css)
embed("index.html,report.css,report.js")
