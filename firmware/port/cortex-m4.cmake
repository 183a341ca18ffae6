# Cross build for an Arm Cortex-M4 with single-precision FPU (Debian: gcc-arm-none-eabi,
# libnewlib-arm-none-eabi):
#
#   cmake --preset cortex-m4 && cmake --build --preset cortex-m4
#
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)

set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)   # there is nothing to link a program with

# One section per function: the program that takes the library drops what it does not call.
set(cortex_m4_flags "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffunction-sections")
set(CMAKE_C_FLAGS_INIT "${cortex_m4_flags}")
set(CMAKE_CXX_FLAGS_INIT "${cortex_m4_flags}")
set(CMAKE_ASM_FLAGS_INIT "${cortex_m4_flags}")

# Libraries and headers of the build machine are not the target's.
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
