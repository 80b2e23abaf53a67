# What `cmake --install` and `cpack -G DEB` put where. The programs find their resources in
# ../share/rotorbench beside them, so the prefix is free.
install(TARGETS rotorbench-cli RUNTIME)
install(DIRECTORY resources/experiments resources/help resources/icons resources/library resources/validation
        DESTINATION ${CMAKE_INSTALL_DATADIR}/rotorbench
        PATTERN "*.py" EXCLUDE)

# Man pages and the change log carry the version and are compressed as Debian wants them: no name and
# no time in the file.
function(rotorbench_install_compressed source destination)
  get_filename_component(name ${source} NAME)
  set(text ${PROJECT_BINARY_DIR}/compressed/${name})
  configure_file(${source} ${text} @ONLY)
  execute_process(COMMAND gzip -9nc ${text} OUTPUT_FILE ${text}.gz COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${text}.gz DESTINATION ${destination})
endfunction()
rotorbench_install_compressed(resources/man/rotorbench-cli.1 ${CMAKE_INSTALL_MANDIR}/man1)

if(TARGET rotorbench)
  install(TARGETS rotorbench RUNTIME)
  rotorbench_install_compressed(resources/man/rotorbench.1 ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES resources/icons/rotorbench.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
  install(FILES resources/rotorbench.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES resources/rotorbench-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
          RENAME rotorbench.xml)
  install(FILES resources/rotorbench.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rotorbench)
set(CPACK_PACKAGE_VENDOR "Rotorbench")
set(CPACK_PACKAGE_CONTACT "Rotorbench developers <rotorbench@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "workbench that simulates and analyses quadrotors and their parts")
set(CPACK_PACKAGE_DESCRIPTION
"Rotorbench computes how a quadrotor flies before it is built: rotors, motors,
battery, controllers and sensors, with published models and data. The window
shows live charts and a 3D view; the command line gives the same numbers.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The libraries come from dpkg-shlibdeps; plugins, icons and the font are loaded by name.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, breeze-icon-theme, fonts-dejavu-core | fonts-liberation")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-wayland")
set(CMAKE_INSTALL_DOCDIR ${CMAKE_INSTALL_DATAROOTDIR}/doc/rotorbench)
install(FILES resources/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
rotorbench_install_compressed(resources/debian/changelog ${CMAKE_INSTALL_DOCDIR})
include(CPack)
