# cremona_site(): what is read before and beside the apps, in site/ too: the entrance page with its pictures, which cremona
# draws, the pages of courseware/, and what keeps all of it for a visit without a network.
#
# cremona_page(APP TITLE): the page of an app, in site/ of the build folder: APP.html, what it runs, and its files: the fonts,
# cut down to the characters that widgets show, and the examples. site/single/APP.html is all of it in one file.
set(site "${PROJECT_BINARY_DIR}/site")
set(page_folder "${PROJECT_SOURCE_DIR}/ui/app/web")
set(page_files "${PROJECT_BINARY_DIR}/page_files")

# Of letters the European ones and Greek, of signs those of the interface (tests/web/characters_test.py) and of mechanics.
set(characters
  0020-007E,00A0-017F,0192,01E4-01EF,01FA-01FF,0218-021B,02B2,02C6,02C7,02D8-02DD,0384-03CE,03D1,03D5,03D6,03F1,03F5,1D40,1D62
  2010-2016,2018-2022,2026,2030,2032-2034,2039,203A,2044,2070,2071,2074-208E,2090-209C,20AC,2103,2109,2113,2116,2122,2126,212B
  2190-2199,21B6,21B7,21BA,21BB,21D0-21D4,21E5,2202,2206-2208,2211,2212,2215,221A,221D-2220,2225,2227-222B,222E,2234,2245,2248
  2260,2261,2264,2265,226A,226B,22A5,22C5,22EE,22EF,2500,258F,25A0,25A1,25AA,25AB,25B2-25C3,25C6,25C7,25CA,25CB,25CF,25E1-25E5
  2713,2717,2718,27C2,27E8,27E9,FFFD)
list(JOIN characters "," characters)
set(fonts "")
foreach(font DejaVuSans DejaVuSans-Bold)
  add_custom_command(OUTPUT "${page_files}/fonts/${font}.ttf"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${page_files}/fonts"
    COMMAND /usr/bin/python3 -m fontTools.subset "/usr/share/fonts/truetype/dejavu/${font}.ttf" --unicodes=${characters}
            --no-hinting --layout-features= --drop-tables+=FFTM "--output-file=${page_files}/fonts/${font}.ttf"
    DEPENDS "${CMAKE_CURRENT_LIST_FILE}" VERBATIM)
  list(APPEND fonts "${page_files}/fonts/${font}.ttf")
endforeach()
file(GLOB examples CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/*.json" "${PROJECT_SOURCE_DIR}/examples/*.eul")
file(MAKE_DIRECTORY "${page_files}/examples")
file(COPY ${examples} DESTINATION "${page_files}/examples")
add_custom_target(page_files DEPENDS ${fonts})

function(cremona_page app title)
  set_target_properties(${app} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${site}")
  set_property(TARGET ${app} APPEND PROPERTY LINK_DEPENDS ${fonts})
  add_dependencies(${app} page_files)
  target_link_options(${app} PRIVATE -sENVIRONMENT=web -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sDYNAMIC_EXECUTION=0
    -lidbfs.js
    "SHELL:--preload-file ${page_files}@/")
  configure_file("${page_folder}/app.html.in" "${site}/${app}.html" @ONLY)
  foreach(script embed.js page.js qr.js share.js)
    configure_file("${page_folder}/${script}" "${site}/${script}" COPYONLY)
  endforeach()
  set(single "${site}/single/${app}.html")
  add_custom_command(OUTPUT "${single}"
    COMMAND /usr/bin/python3 "${page_folder}/single_file.py" "${site}" ${app} "${single}"
    DEPENDS ${app} "${page_folder}/single_file.py" "${site}/${app}.html" "${site}/page.js" "${site}/qr.js"
            "${site}/share.js" "${site}/embed.js" ui_translations
    VERBATIM)
  add_custom_target(${app}_page ALL DEPENDS "${single}")
  set_property(GLOBAL APPEND PROPERTY CREMONA_PAGES "${single}")
endfunction()

function(cremona_site)
  set(folder "${PROJECT_SOURCE_DIR}/apps/web")
  set(done "${PROJECT_BINARY_DIR}/site_done")
  file(MAKE_DIRECTORY "${done}")
  file(GLOB read CONFIGURE_DEPENDS "${folder}/*.py" "${folder}/gallery.json")
  file(GLOB_RECURSE courseware CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/courseware/*")
  foreach(file site.css entrance.js offline.js)
    configure_file("${folder}/${file}" "${site}/${file}" COPYONLY)
  endforeach()
  add_custom_command(OUTPUT "${done}/pictures"
    COMMAND /usr/bin/python3 "${folder}/gallery.py" "${PROJECT_SOURCE_DIR}" "${site}" ${CMAKE_CROSSCOMPILING_EMULATOR}
            $<TARGET_FILE:cremona>
    COMMAND "${CMAKE_COMMAND}" -E touch "${done}/pictures"
    DEPENDS cremona "${folder}/gallery.py" "${folder}/gallery.json" ${examples}
    VERBATIM)
  add_custom_command(OUTPUT "${done}/pages"
    COMMAND /usr/bin/python3 "${folder}/entrance.py" "${PROJECT_SOURCE_DIR}" "${site}"
    COMMAND /usr/bin/python3 "${folder}/courseware_pages.py" "${PROJECT_SOURCE_DIR}" "${site}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${done}/pages"
    DEPENDS ${read} ${courseware} ${examples}
    VERBATIM)
  # Last, since it knows all that is there.
  get_property(pages GLOBAL PROPERTY CREMONA_PAGES)
  add_custom_command(OUTPUT "${site}/service_worker.js"
    COMMAND /usr/bin/python3 "${folder}/offline.py" "${PROJECT_SOURCE_DIR}" "${site}"
    DEPENDS "${done}/pictures" "${done}/pages" ${pages} "${folder}/offline.py" "${folder}/service_worker.js" "${site}/site.css"
            "${site}/entrance.js" "${site}/offline.js"
    VERBATIM)
  add_custom_target(site ALL DEPENDS "${site}/service_worker.js")
endfunction()
