# fw_runner for a Cortex-M4F: laid out by the IWRL6432's memory map, run by QEMU's mps2-an386.
# Beside the program come its map, and of every source file the stack frames (.su) and calls (.ci).
set(mps2 ${CMAKE_CURRENT_LIST_DIR})
target_sources(fw_runner PRIVATE ${mps2}/fw_port_mps2.c ${mps2}/fw_startup.c)
foreach(target specula_firmware fw_runner)
    target_compile_options(${target} PRIVATE -fdata-sections -fstack-usage -fcallgraph-info=su)
endforeach()
target_link_options(fw_runner PRIVATE -nostartfiles --specs=nano.specs -T ${mps2}/xwrl6432.ld
    -Wl,--gc-sections -Wl,-Map=fw_runner.map)
set_target_properties(fw_runner PROPERTIES SUFFIX .elf LINK_DEPENDS ${mps2}/xwrl6432.ld)
