#include "vulkan/groups.h"
#include "vulkan/spirv/exact_sums.h"
#include "vulkan/spirv/float_atomics.h"
#include "vulkan/spirv/float_controls.h"
#include "vulkan/spirv/hidden_limits.h"
#include "vulkan/spirv/hidden_zeros.h"
#include "vulkan/spirv/separate_texels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <spirv-tools/libspirv.hpp>

namespace glift::detail {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::uint32_t> assembled(const std::string& text) {
    std::vector<std::uint32_t> words;
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    EXPECT_TRUE(tools.Assemble(text, &words, SPV_TEXT_TO_BINARY_OPTION_PRESERVE_NUMERIC_IDS));
    return words;
}

std::string disassembled(const std::vector<std::uint32_t>& words) {
    std::string text;
    spvtools::SpirvTools(SPV_ENV_VULKAN_1_3).Disassemble(words, &text);
    return text;
}

std::string error_of(const std::vector<std::uint32_t>& words) {
    std::string error;
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) { error = message; });
    return tools.Validate(words) ? "" : error;
}

/// A shader with 32-bit and 64-bit integers. Id %64 is a value of a 32-bit type: its number must not be taken for a
/// width.
const std::string shader = R"(
    OpCapability Shader
    OpCapability Int64
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %4 "main" %20
    OpExecutionMode %4 LocalSize 1 1 1
    OpDecorate %20 BuiltIn GlobalInvocationId
    %2 = OpTypeVoid
    %3 = OpTypeFunction %2
    %7 = OpTypeInt 64 0
    %8 = OpTypeInt 32 0
    %9 = OpTypeVector %8 3
    %10 = OpTypeFloat 32
    %11 = OpConstant %10 0
    %12 = OpTypePointer Input %9
    %20 = OpVariable %12 Input
    %4 = OpFunction %2 None %3
    %21 = OpLabel
    %22 = OpLoad %9 %20
    %64 = OpCompositeExtract %8 %22 1
    %65 = OpConvertUToF %10 %64
    %66 = OpFMul %10 %65 %11
    OpReturn
    OpFunctionEnd
)";

/// A shader that adds to a float in workgroup memory and, where `texel` is not empty, to a texel.
std::string adding_shader(const std::string& texel) {
    return R"(
    OpCapability Shader
    OpCapability AtomicFloat32AddEXT
    OpExtension "SPV_EXT_shader_atomic_float_add"
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %4 "main"
    OpExecutionMode %4 LocalSize 1 1 1
    OpDecorate %33 DescriptorSet 0
    OpDecorate %33 Binding 1
    %2 = OpTypeVoid
    %3 = OpTypeFunction %2
    %8 = OpTypeInt 32 0
    %9 = OpConstant %8 1
    %17 = OpConstant %8 0
    %10 = OpTypeFloat 32
    %11 = OpConstant %10 2.5
    %12 = OpTypePointer Workgroup %10
    %20 = OpVariable %12 Workgroup
    %30 = OpTypeImage %10 1D 0 0 0 2 R32f
    %31 = OpTypePointer UniformConstant %30
    %32 = OpTypePointer Image %10
    %33 = OpVariable %31 UniformConstant
    %4 = OpFunction %2 None %3
    %21 = OpLabel
    %22 = OpAtomicFAddEXT %10 %20 %9 %17 %11
    )" + texel +
           R"(
    OpReturn
    OpFunctionEnd
)";
}

TEST(FloatAtomics, AreTakenOutWithTheirCapability) {
    const std::vector<std::uint32_t> words = without_float_atomics(assembled(adding_shader("")));
    const std::string text = disassembled(words);
    for (const char* op : {"AtomicFAdd", "AtomicFloat32Add", "shader_atomic_float"})
        EXPECT_THAT(text, Not(HasSubstr(op)));
    EXPECT_THAT(text, HasSubstr("OpCopyObject %float %float_2_5"));
}

TEST(FloatAtomics, StayInImages) {
    const std::string texel = "%23 = OpImageTexelPointer %32 %33 %17 %17\n%24 = OpAtomicFAddEXT %10 %23 %9 %17 %11";
    const std::string text = disassembled(without_float_atomics(assembled(adding_shader(texel))));
    EXPECT_THAT(text, HasSubstr("OpCapability AtomicFloat32AddEXT"));
    EXPECT_THAT(text, HasSubstr("OpAtomicFAddEXT %float %23"));
    EXPECT_THAT(text, HasSubstr("OpCopyObject %float %float_2_5"));
}

TEST(HiddenZeros, TellTheWidthOfATypeFromAValue) {
    const std::vector<std::uint32_t> hidden = with_hidden_zeros(assembled(shader));
    EXPECT_EQ(error_of(hidden), "") << disassembled(hidden);
    EXPECT_THAT(disassembled(hidden), HasSubstr("OpBitwiseOr %uint %64"));
    EXPECT_THAT(disassembled(hidden), Not(HasSubstr("OpFMul %float %65 %float_0")));
}

/// A shader that takes a component of a vector of constants (%50), has a variable that is initialised with such a
/// vector (%40), and computes a step of numbers that are converted from an unsigned integer (%51).
const std::string found_zeros = R"(
    OpCapability Shader
    %1 = OpExtInstImport "GLSL.std.450"
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %4 "main" %20
    OpExecutionMode %4 LocalSize 1 1 1
    OpDecorate %20 BuiltIn GlobalInvocationId
    %2 = OpTypeVoid
    %3 = OpTypeFunction %2
    %8 = OpTypeInt 32 0
    %9 = OpTypeVector %8 3
    %10 = OpTypeFloat 32
    %11 = OpTypeVector %10 2
    %12 = OpTypePointer Input %9
    %13 = OpTypePointer Function %11
    %14 = OpConstant %10 2
    %15 = OpConstantComposite %11 %14 %14
    %20 = OpVariable %12 Input
    %4 = OpFunction %2 None %3
    %21 = OpLabel
    %40 = OpVariable %13 Function %15
    %22 = OpLoad %9 %20
    %23 = OpCompositeExtract %8 %22 1
    %24 = OpConvertUToF %10 %23
    %25 = OpCompositeConstruct %11 %24 %24
    %50 = OpCompositeExtract %10 %15 0
    %51 = OpExtInst %11 %1 Step %15 %25
    OpReturn
    OpFunctionEnd
)";

TEST(HiddenZeros, HideWhatADriverMayMakeZerosOf) {
    const std::vector<std::uint32_t> hidden = with_hidden_zeros(assembled(found_zeros));
    const std::string text = disassembled(hidden);
    EXPECT_EQ(error_of(hidden), "") << text;
    EXPECT_THAT(text, Not(HasSubstr("%50 = OpCompositeExtract %float %15 0")));
    EXPECT_THAT(text, HasSubstr("%40 = OpVariable %_ptr_Function_v2float Function\n"));
    EXPECT_THAT(text, HasSubstr("OpStore %40"));
    EXPECT_THAT(text, HasSubstr("%51 = OpFAdd %v2float"));
}

/// Sums and differences of a constant with: itself (%40); a number (%24) that is converted from a loaded integer (%41);
/// the loaded value of a variable to which a constant is stored later (%43); the value of a variable to which only %24
/// is stored (%45). And of vectors of constants (%46).
const std::string sums = R"(
    OpCapability Shader
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %4 "main" %20
    OpExecutionMode %4 LocalSize 1 1 1
    OpDecorate %20 BuiltIn GlobalInvocationId
    %2 = OpTypeVoid
    %3 = OpTypeFunction %2
    %8 = OpTypeInt 32 0
    %9 = OpTypeVector %8 3
    %10 = OpTypeFloat 32
    %11 = OpConstant %10 22642620
    %12 = OpTypePointer Input %9
    %13 = OpTypePointer Function %10
    %14 = OpTypeVector %10 2
    %15 = OpConstantComposite %14 %11 %11
    %20 = OpVariable %12 Input
    %4 = OpFunction %2 None %3
    %21 = OpLabel
    %30 = OpVariable %13 Function
    %31 = OpVariable %13 Function
    %22 = OpLoad %9 %20
    %23 = OpCompositeExtract %8 %22 1
    %24 = OpConvertUToF %10 %23
    %40 = OpFSub %10 %11 %11
    %41 = OpFAdd %10 %11 %24
    %42 = OpLoad %10 %30
    %43 = OpFSub %10 %42 %11
    OpStore %30 %43
    OpStore %30 %11
    OpStore %31 %24
    %44 = OpLoad %10 %31
    %45 = OpFSub %10 %44 %11
    %46 = OpFAdd %14 %15 %15
    OpReturn
    OpFunctionEnd
)";

TEST(KeptSums, CombineConstantsWithWhatTheDriverDoesNotKnow) {
    const std::vector<std::uint32_t> kept = with_kept_sums(assembled(sums));
    const std::string text = disassembled(kept), before = disassembled(assembled(sums));
    EXPECT_EQ(error_of(kept), "") << text;
    for (const char* gone : {"%40 = OpFSub %float %float_22642620 %float_22642620", "%43 = OpFSub %float %42",
                             "%46 = OpFAdd %v2float %15 %15"})
        EXPECT_THAT(std::make_pair(text, before), testing::Pair(Not(HasSubstr(gone)), HasSubstr(gone)));
    for (const char* stays : {"%41 = OpFAdd %float %float_22642620 %24", "%45 = OpFSub %float %44 %float_22642620"})
        EXPECT_THAT(text, HasSubstr(stays));
}

/// A shader that compares a number of the workgroup (%23) with 0, 1 and 2, and stores `begin` to a variable. It also
/// compares with a copy of 1 (OpCopyObject), as the runtime makes of a parameter that is fixed for a pipeline.
std::string limits(const std::string& begin) {
    return R"(
    OpCapability Shader
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %4 "main" %20
    OpExecutionMode %4 LocalSize 1 1 1
    OpDecorate %20 BuiltIn WorkgroupId
    %2 = OpTypeVoid
    %3 = OpTypeFunction %2
    %5 = OpTypeBool
    %7 = OpTypeInt 32 1
    %8 = OpTypeInt 32 0
    %9 = OpTypeVector %8 3
    %10 = OpConstant %7 0
    %11 = OpConstant %7 1
    %12 = OpConstant %7 2
    %13 = OpConstant %7 )" +
           begin + R"(
    %14 = OpTypePointer Input %9
    %15 = OpTypePointer Function %7
    %20 = OpVariable %14 Input
    %4 = OpFunction %2 None %3
    %21 = OpLabel
    %30 = OpVariable %15 Function
    OpStore %30 %13
    %22 = OpLoad %9 %20
    %24 = OpCompositeExtract %8 %22 0
    %23 = OpBitcast %7 %24
    %40 = OpSLessThan %5 %23 %11
    %41 = OpSLessThanEqual %5 %23 %10
    %42 = OpSGreaterThan %5 %11 %23
    %43 = OpSGreaterThanEqual %5 %10 %23
    %44 = OpSGreaterThan %5 %23 %10
    %45 = OpSGreaterThanEqual %5 %23 %11
    %46 = OpSLessThan %5 %10 %23
    %47 = OpSLessThanEqual %5 %11 %23
    %25 = OpCopyObject %7 %11
    %48 = OpSLessThan %5 %23 %25
    %50 = OpSLessThan %5 %23 %10
    %51 = OpSLessThan %5 %23 %12
    %52 = OpSGreaterThan %5 %23 %11
    OpReturn
    OpFunctionEnd
)";
}

/// The comparisons that stand unchanged in the text of a module, by id.
std::vector<int> unchanged(const std::string& text, const std::string& before) {
    std::vector<int> result;
    for (int id = 40; id <= 52; ++id) {
        const std::string start = "%" + std::to_string(id) + " = Op";
        const std::size_t at = before.find(start);
        if (at == std::string::npos) continue;
        const std::string whole = before.substr(at, before.find('\n', at) - at);
        if (text.find(whole) != std::string::npos) result.push_back(id);
    }
    return result;
}

TEST(HiddenLimits, AreThoseThatTellZeroFromOne) {
    const std::vector<std::uint32_t> before = assembled(limits("-2")), hidden = with_hidden_limits(before);
    EXPECT_EQ(error_of(hidden), "") << disassembled(hidden);
    EXPECT_THAT(unchanged(disassembled(hidden), disassembled(before)), testing::ElementsAre(50, 51, 52));
}

TEST(HiddenLimits, AreInModulesAloneWithLoopsThatMayGoWrong) {
    for (const char* begin : {"-1", "3"}) {
        const std::vector<std::uint32_t> before = assembled(limits(begin));
        EXPECT_EQ(with_hidden_limits(before), before) << begin;
    }
}

/// A shader that writes one texel of an image with these components.
std::string texels(const std::string& component, const std::string& format) {
    return R"(
    OpCapability Shader
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %4 "main" %20 %21
    OpExecutionMode %4 LocalSize 1 1 1
    OpDecorate %20 BuiltIn WorkgroupId
    OpDecorate %21 DescriptorSet 0
    OpDecorate %21 Binding 1
    OpDecorate %21 NonReadable
    %2 = OpTypeVoid
    %3 = OpTypeFunction %2
    %8 = OpTypeInt 32 0
    %9 = OpTypeVector %8 3
    %10 = )" +
           component + R"(
    %11 = OpTypeVector %10 4
    %12 = OpTypeImage %10 2D 0 0 0 2 )" +
           format + R"(
    %13 = OpTypePointer UniformConstant %12
    %14 = OpTypePointer Input %9
    %15 = OpConstant %10 7
    %16 = OpConstantComposite %11 %15 %15 %15 %15
    %17 = OpTypeVector %8 2
    %20 = OpVariable %14 Input
    %21 = OpVariable %13 UniformConstant
    %4 = OpFunction %2 None %3
    %22 = OpLabel
    %23 = OpLoad %9 %20
    %24 = OpVectorShuffle %17 %23 %23 0 1
    %25 = OpLoad %12 %21
    OpImageWrite %25 %24 %16
    OpReturn
    OpFunctionEnd
)";
}

TEST(SeparateTexels, AddUnknownZerosToThreeComponents) {
    const std::vector<std::uint32_t> separate = with_separate_texels(assembled(texels("OpTypeInt 32 1", "Rgba32i")));
    const std::string text = disassembled(separate);
    EXPECT_EQ(error_of(separate), "") << text;
    EXPECT_THAT(text, Not(HasSubstr("OpImageWrite %25 %24 %16")));
    for (const char* insertion : {"%16 1\n", "%32 2\n", "%36 3\n"}) EXPECT_THAT(text, HasSubstr(insertion));
}

TEST(SeparateTexels, LeaveTexelsOfFloatsAsTheyAre) {
    const std::vector<std::uint32_t> before = assembled(texels("OpTypeFloat 32", "Rgba32f"));
    EXPECT_EQ(with_separate_texels(before), before);
}

TEST(Groups, LeaveTheTopBitOfAnInvocationsNumberUnset) {
    Kernel kernel{};
    for (std::uint32_t width : {32u, 256u, 1024u}) {
        kernel.group[0] = width;
        EXPECT_LE(std::uint64_t{limit_along_x(kernel, 0x7fffffffu)} * width, 0x7fffffffu) << width;
        EXPECT_EQ(limit_along_x(kernel, 65535), 65535u) << width;
    }
}

TEST(FloatControls, SetEachModeThatTheDeviceHasForEachWidth) {
    VkPhysicalDeviceVulkan12Properties properties{};
    properties.denormBehaviorIndependence = VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_ALL;
    properties.roundingModeIndependence = VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_ALL;
    properties.shaderDenormPreserveFloat16 = VK_TRUE;
    properties.shaderSignedZeroInfNanPreserveFloat32 = properties.shaderSignedZeroInfNanPreserveFloat64 = VK_TRUE;
    const std::string text = disassembled(with_float_modes(assembled(shader), FloatControls::of(properties).modes));
    for (const char* mode : {"OpCapability DenormPreserve", "DenormPreserve 16", "SignedZeroInfNanPreserve 32",
                             "SignedZeroInfNanPreserve 64"})
        EXPECT_THAT(text, HasSubstr(mode));
    for (const char* mode : {"DenormPreserve 32", "SignedZeroInfNanPreserve 16", "RoundingModeRTE"})
        EXPECT_THAT(text, Not(HasSubstr(mode)));
}

TEST(FloatControls, LeaveRoundingOfFloatsToNvidia) {
    VkPhysicalDeviceVulkan12Properties properties{};
    properties.roundingModeIndependence = VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_ALL;
    properties.shaderRoundingModeRTEFloat16 = properties.shaderRoundingModeRTEFloat32 =
        properties.shaderRoundingModeRTEFloat64 = VK_TRUE;
    const auto text_for = [&](VkDriverId driver) {
        properties.driverID = driver;
        return disassembled(with_float_modes(assembled(shader), FloatControls::of(properties).modes));
    };
    EXPECT_THAT(text_for(VK_DRIVER_ID_NVIDIA_PROPRIETARY), Not(HasSubstr("RoundingModeRTE 32")));
    for (const char* mode : {"RoundingModeRTE 16", "RoundingModeRTE 64"})
        EXPECT_THAT(text_for(VK_DRIVER_ID_NVIDIA_PROPRIETARY), HasSubstr(mode));
    EXPECT_THAT(text_for(VK_DRIVER_ID_MESA_RADV), HasSubstr("RoundingModeRTE 32"));
}

TEST(FloatControls, KeepToWhatTheDeviceTiesTogether) {
    VkPhysicalDeviceVulkan12Properties properties{};
    properties.denormBehaviorIndependence = VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_32_BIT_ONLY;
    properties.roundingModeIndependence = VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_NONE;
    properties.shaderDenormPreserveFloat16 = properties.shaderDenormPreserveFloat32 = VK_TRUE;
    properties.shaderRoundingModeRTEFloat16 = properties.shaderRoundingModeRTEFloat32 = VK_TRUE;
    const std::string text = disassembled(with_float_modes(assembled(shader), FloatControls::of(properties).modes));
    EXPECT_THAT(text, HasSubstr("DenormPreserve 32"));
    for (const char* mode : {"DenormPreserve 16", "RoundingModeRTE"}) EXPECT_THAT(text, Not(HasSubstr(mode)));
}

}  // namespace
}  // namespace glift::detail
