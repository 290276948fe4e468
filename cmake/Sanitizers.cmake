# -DRMPL_SANITIZE=address,undefined instruments everything that is built.
if(RMPL_SANITIZE)
  add_compile_options(-fsanitize=${RMPL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${RMPL_SANITIZE})
endif()
