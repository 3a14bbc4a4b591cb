# The Debian package: cpack -G DEB in the build folder, after the build. Needs dpkg-dev and file (demos/setup package).
set(CPACK_PACKAGE_NAME pushfactor)
set(CPACK_PACKAGE_VENDOR "Pushfactor developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "constraint based rigid bodies, rendered without a display")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)

set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Pushfactor developers")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Simulates rigid bodies with contacts, friction, bars and joints, and renders
them as pictures, videos and pages that play a run in a browser. Implements
Tamis and Maggiore, Constraint based physics solver (2015), with single-frame
push factors. Mesa draws on the CPU; no display and no graphics card is used.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded at run time: OSMesa, or else the three packages of EGL; and the font.
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "libosmesa6 | libegl1, libosmesa6 | libegl-mesa0, libosmesa6 | libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, gnuplot-nox")
include(CPack)
