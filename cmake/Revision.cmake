# cmake -DSOURCE_DIR=.. -DOUTPUT=.. -P Revision.cmake: writes the commit into a header, only if it changed.
# Runs at every build, so that an artifact never names a commit the program was not built from.
set(archived "$Format:%h$")  # filled in by git archive, see .gitattributes

set(revision "unknown")
if(EXISTS "${SOURCE_DIR}/.git")
  find_program(GIT git)
  if(GIT)
    # The owner of the checkout may differ from the user who builds (root in a container); only its commit is read.
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -E env GIT_OPTIONAL_LOCKS=0 "${GIT}" -c safe.directory=* -C "${SOURCE_DIR}"
              -c core.fsmonitor=false describe --always --dirty --abbrev=12 --exclude=*
      OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed)
      set(revision "${described}")
    endif()
  endif()
elseif(NOT archived MATCHES "Format")
  set(revision "${archived}")
endif()

set(content "#define ASHIMPACT_REVISION \"${revision}\"\n")
set(before "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT before STREQUAL content)
  file(WRITE "${OUTPUT}" "${content}")
endif()
