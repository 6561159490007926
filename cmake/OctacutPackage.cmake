# `cpack` makes octacut_VERSION_ARCHITECTURE.deb of the component runtime, whose
# dependencies dpkg-shlibdeps (package dpkg-dev) finds.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME octacut)
set(CPACK_PACKAGE_VENDOR "octacut developers")
set(CPACK_PACKAGE_CONTACT "octacut developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
    "closed meshes from COLMAP sparse models and silhouette masks")
set(CPACK_PACKAGE_DESCRIPTION
    "octacut turns a COLMAP reconstruction of an object and one silhouette mask
 for each photograph into a closed, printable triangle mesh, without a GPU.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME octacut)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The pages of mesh_comparer and mesh_evaluator contain three.js.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libjs-three, jq")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS colmap)
include(CPack)
