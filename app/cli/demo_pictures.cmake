# SPDX-License-Identifier: Apache-2.0
# cmake -DSLINE=program -DFOLDER=folder -DMODELS=folder -P demo_pictures.cmake: draws the start page's
# pictures of the demos into the first folder, on the processor, so that they are the same
# everywhere; the second keeps the modelled scenes. A machine without EGL can build, too: then the
# page draws them itself.
file(REMOVE_RECURSE ${FOLDER})
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LIBGL_ALWAYS_SOFTWARE=1 ${SLINE} demo-pictures ${FOLDER} ${MODELS}
  RESULT_VARIABLE failed ERROR_VARIABLE said)
if(failed)
  file(REMOVE_RECURSE ${FOLDER})
  message(NOTICE "The start page will draw the demos itself: ${said}")
endif()
