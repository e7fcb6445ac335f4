# tandem_idl(file ...): generates C++ for each IDL file (fastddsgen), repairs it, and makes the library tandem_idl.
#
# fastddsgen writes included files again under their base name, so each file is generated into a folder of its own and
# only its own four outputs are kept. Its deserialize() catches NotEnoughMemoryException alone; a sample with an unknown
# CDR encapsulation throws another type out of the reader thread and ends the process, so the catch is widened.
# Sequences of an enum are resized to whatever length the sample claims, gigabytes if it says so: that is limited.
function(tandem_idl)
  set(kept ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(sources)
  foreach(file ${ARGN})
    get_filename_component(name ${file} NAME_WE)
    set(own ${CMAKE_CURRENT_BINARY_DIR}/generate_${name})
    set(outputs ${name}.h ${name}.cxx ${name}PubSubTypes.h ${name}PubSubTypes.cxx)
    list(TRANSFORM outputs PREPEND ${kept}/ OUTPUT_VARIABLE kept_outputs)
    list(TRANSFORM outputs PREPEND ${own}/ OUTPUT_VARIABLE own_outputs)
    add_custom_command(
      OUTPUT ${kept_outputs}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${own}/tmp ${kept}
      COMMAND ${FASTDDSGEN} -cs -replace -I ${CMAKE_CURRENT_SOURCE_DIR} -t ${own}/tmp -d ${own}
              ${CMAKE_CURRENT_SOURCE_DIR}/${file} > ${own}/fastddsgen.log
      COMMAND sed -i "s/catch (eprosima::fastcdr::exception::NotEnoughMemoryException& [^)]*)/catch (...)/"
              ${own}/${name}PubSubTypes.cxx
      COMMAND sed -i "s/dcdr >> seq_length;/& if (seq_length > 4096) throw eprosima::fastcdr::exception::BadParamException(\"sequence too long\");/"
              ${own}/${name}.cxx
      COMMAND ${CMAKE_COMMAND} -E copy ${own_outputs} ${kept}
      DEPENDS ${ARGN}
      COMMENT "Generating C++ from ${file}"
      VERBATIM)
    list(APPEND sources ${kept}/${name}.cxx ${kept}/${name}PubSubTypes.cxx)
  endforeach()
  add_library(tandem_idl STATIC ${sources})
  set_target_properties(tandem_idl PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 4)
  target_include_directories(tandem_idl SYSTEM PUBLIC ${kept})
  target_include_directories(tandem_idl PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(tandem_idl PUBLIC fastrtps fastcdr)
  if(TANDEM_SANITIZER)
    target_compile_options(tandem_idl PUBLIC -fsanitize=${TANDEM_SANITIZER})
  endif()
endfunction()

# Equal hash, equal wire format: two hosts whose hashes differ do not search together.
file(GLOB idl_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/idl/*.idl)
set(all_idl "")
foreach(file ${idl_files})
  file(SHA256 ${file} hash)
  string(APPEND all_idl ${hash})
endforeach()
string(SHA256 TANDEM_CONTRACT_HASH "${all_idl}")
string(SUBSTRING ${TANDEM_CONTRACT_HASH} 0 16 TANDEM_CONTRACT_HASH)
