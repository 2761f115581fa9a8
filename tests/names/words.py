"""The words that names_test.py tries."""
import random
import re

# Words that are never tried, since they cannot be identifiers: Glift's keywords and literals.
LANGUAGE = set("""module use pub extern fn struct enum interface let var const if else for in while switch break continue return
true false none await then""".split())

CPP = """alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class co_await
co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete do double
dynamic_cast else enum explicit export extern false final float for friend goto if import inline int long module mutable
namespace new noexcept not not_eq nullptr operator or or_eq override private protected public register reinterpret_cast
requires return short signed sizeof static static_assert static_cast struct switch template this thread_local throw true try
typedef typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq std glift main half uint float4
uint3x3 restrict typeof __LINE__ _Bool _x __x x__y y_ z__ _""".split()

GLSL = """attribute atomic_uint buffer bvec2 centroid coherent discard demote dmat2 dmat3x4 dvec2 flat highp inout invariant
ivec2 layout lowp mat2 mat4x4 mediump noperspective nonuniformEXT out patch precise precision readonly restrict sample sampler
sampler2D samplerCube samplerShadow shared smooth subroutine subpassInput texture texture2D image2D iimage3D uimageBuffer
textureCube uniform uvec2 varying vec2 vec4 writeonly fixed superp int8_t uint8_t int16_t int64_t uint64_t float16_t float64_t
f16vec2 i64vec2 u64vec4 f32mat2 workgroupcoherent subgroupcoherent nonprivate volatile common partition active resource
noinline external long short input output hvec2 fvec2 filter cast sampler3DRect packed row_major column_major
gl_Position gl_x radians sin cosh pow exp2 inversesqrt abs sign mod modf min mix step isnan fma frexp ldexp length distance
dot cross faceforward outerProduct transpose determinant inverse lessThan equal any all not uaddCarry umulExtended
bitfieldExtract bitCount findLSB texelFetch texelFetchOffset textureSize textureLod textureGather textureQueryLevels imageLoad
imageStore imageAtomicAdd imageSize barrier memoryBarrier memoryBarrierShared groupMemoryBarrier controlBarrier noise1
floatBitsToInt packHalf2x16 packUnorm2x16 packSnorm4x8 packDouble2x32 unpackDouble2x32 packUint2x32 pack32 matrixCompMult
matrixCompMul atomicAdd atomicCounter atomicLoad subgroupAdd subgroupElect subgroupMemoryBarrier fwidth dFdx dFdxFine
interpolateAtCentroid EmitVertex debugPrintfEXT defined extension version line pragma GL_core_profile VULKAN
accelerationStructureEXT rayQueryEXT hitObjectNV taskNV perprimitiveNV coopmatNV fcoopmatNV spirv_instruction
nontemporal devicecoherent queuefamilycoherent shadercallcoherent sampler1DArrayShadow ftexture ftexture1D""".split()

C = """NULL EOF errno INFINITY NAN assert major minor linux unix near far stdin stdout stderr offsetof setjmp va_arg INT_MAX CHAR_BIT
BUFSIZ RAND_MAX SEEK_SET CLOCKS_PER_SEC EXIT_SUCCESS EINTR SIGINT M_PI MAP_FAILED O_RDONLY st_mtime sa_handler dup2 read write
pipe link index select time clock signal stat wait sync open close printf malloc free exit abort y0 j1 gamma div tm timeval FILE
environ optarg daylight timezone random rand remove rename round truncate log exp memcpy strlen size_t ssize_t int32_t group
passwd option entry TRUE FALSE ERROR IN OUT i386""".split()


def identifiers_of(text):
    return set(re.findall(r"\b[A-Za-z_]\w*", re.sub(r'//.*|"(?:[^"\\]|\\.)*"', " ", text)))


def identifiers(paths):
    return set().union(*(identifiers_of(path.read_text(errors="replace")) for path in paths))


def words_for(root, position, limit, needed):
    """The words for a position, all or a sample, in an order that depends only on the position; without words that its module
    needs."""
    always = [w for w in dict.fromkeys(CPP + GLSL + C)]
    members = identifiers(root.glob("runtime/include/glift/*structure*.h"))
    generated = identifiers(root.glob("tests/golden/kernels/*.expected.cpp")) | identifiers(
        root.glob("tests/golden/pipelines/*.expected.*")) | identifiers(root.glob("tests/golden/kernels/*.expected.*glsl"))
    runtime = identifiers(root.glob("runtime/include/glift/**/*.h"))
    tables = set()
    for table in ("macros", "globals"):
        tables |= set(re.findall(r'"(\w+)"', (root / f"compiler/emit/cpp/{table}.inc").read_text()))
    order = random.Random(position)
    groups = []
    for group in (always, members, generated, runtime, tables):
        rest = sorted({w for w in set(group).difference(needed, *groups) if not re.match("[zZ]", w)})
        order.shuffle(rest)
        groups.append(rest)
    if limit is None:
        return [w for group in groups for w in group]
    shares = (0.45, 0.2, 0.2, 0.05, 0.1)
    return [w for group, share in zip(groups, shares) for w in group[:max(1, int(limit * share))]]
