# The headers that are for users, in the order in which the data flows. These are installed and no others; they include
# each other only (tests/install holds both), and docs/library.md says what each is for.
set(SINEW_PUBLIC_HEADERS
    base/result.h
    base/progress.h
    base/vec.h
    base/round_cone.h
    skeleton/document.h
    skeleton/graph.h
    skeleton/validate.h
    skeleton/edit.h
    skeleton/symmetry.h
    grow/source.h
    grow/grammar.h
    grow/options.h
    grow/grow.h
    sqm/skin.h
    subdivide/subdivide.h
    smooth/smooth_skin.h
    mesh/quad_mesh.h
    mesh/topology.h
    mesh/normals.h
    mesh/triangulate.h
    mesh/validate.h
    mesh/measure.h
    mesh/intersect.h
    mesh/deviation.h
    mesh/check.h
    io/formats.h
    io/units.h
    io/skeleton_file.h
    io/skeleton_formats.h
    io/mesh_formats.h)

# Those of the component `render`.
set(SINEW_PUBLIC_RENDER_HEADERS
    render/colour.h
    render/bounds.h
    render/camera.h
    render/overlay.h
    render/glyphs.h
    render/mesh_buffers.h
    render/gl_scene.h
    render/picture.h
    render/render.h)

# sinew_install_headers(HEADERS...): each into its folder.
function(sinew_install_headers)
    foreach(header ${ARGN})
        get_filename_component(folder ${header} DIRECTORY)
        install(FILES ${PROJECT_SOURCE_DIR}/src/sinew/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinew/${folder})
    endforeach()
endfunction()
