" Vim syntax file of Glift. Written by tools/editors/make-grammars.
if exists("b:current_syntax")
  finish
endif

syn keyword gliftKeyword module use pub extern fn struct enum interface let var
syn keyword gliftKeyword const
syn keyword gliftControl if else for in while switch break continue return await
syn keyword gliftControl then
syn keyword gliftConstant true false none

syn keyword gliftType bool bool2 bool3 bool4 int int2 int3 int4 uint uint2
syn keyword gliftType uint3 uint4 float float2 float3 float4 half half2 half3 half4
syn keyword gliftType double double2 double3 double4 int64 uint64 vec mat float2x2 float2x3
syn keyword gliftType float2x4 float3x2 float3x3 float3x4 float4x2 float4x3 float4x4 Texel Number Integer
syn keyword gliftType Floating Structure Translator
syn keyword gliftFunction abs acos all asin atan atan2 atomicAdd atomicAnd atomicCompareExchange atomicExchange
syn keyword gliftFunction atomicLoad atomicMax atomicMin atomicOr atomicStore atomicXor bitCount bitfieldExtract bitfieldInsert bitfieldReverse
syn keyword gliftFunction ceil clamp cos cosh cross dFdx dFdy determinant distance dot
syn keyword gliftFunction doubleBitsToUint64 equal exp exp2 findLSB findMSB floatBitsToInt floatBitsToUint floor fma
syn keyword gliftFunction fract fwidth greaterThan greaterThanEqual intBitsToFloat inverse inversesqrt isinf isnan length
syn keyword gliftFunction lessThan lessThanEqual log log2 max min mix mod normalize notEqual
syn keyword gliftFunction packHalf2x16 packUnorm4x8 pow reflect round sign sin sinh smoothstep sqrt
syn keyword gliftFunction step subgroupAdd subgroupAll subgroupAnd subgroupAny subgroupBallot subgroupBallotCount subgroupBallotExclusiveCount subgroupBroadcast subgroupBroadcastFirst
syn keyword gliftFunction subgroupElect subgroupExclusiveAdd subgroupExclusiveMax subgroupExclusiveMin subgroupInclusiveAdd subgroupInclusiveMax subgroupInclusiveMin subgroupMax subgroupMin subgroupMul
syn keyword gliftFunction subgroupOr subgroupShuffle subgroupShuffleDown subgroupShuffleUp subgroupShuffleXor subgroupXor tan tanh transpose trunc
syn keyword gliftFunction uint64BitsToDouble uintBitsToFloat unpackHalf2x16 unpackUnorm4x8

" Words that are names elsewhere count by what follows them.
syn match gliftKeyword /\<\%(type\|structure\|translator\|kernel\|raster\|pipeline\|memory\|host\|shared\|temp\|smooth\|linear\|flat\|cull\|draw\)\>\ze\s\+\w/
syn match gliftDirection /\<\%(out\|inout\)\>\ze\s\+\w/
syn match gliftPattern /\<\%(each\|near\|any\|at\|scatter\|coherent\|calls\|target\|instance\|range\)\>\ze\s*[<,)]/
syn match gliftKeyword /\<\%(via\|otherwise\|uninitialized\|with\|from\|filter\|compare\)\>\ze\s\+[[:alnum:]_"]/
syn match gliftKeyword /\<\%(vertex\|fragment\)\>\ze\s*{/
syn match gliftKeyword /\<\%(group\|mips\|apart\)\>\ze(/
syn match gliftKeyword /\<\%(test\)\>\ze\s*"/
syn match gliftKeyword /\<\%(discard\)\>\ze;/

syn match gliftNumber /\<0[xX]\x\+\%(ul\|[ul]\)\?\>/
syn match gliftNumber /\<\d\+\%(ul\|[ul]\)\?\>/
syn match gliftNumber /\<\d\+\%(\.\d\+\)\?\%([eE][+-]\?\d\+\)\?[fhd]\?\>/
syn match gliftAttribute /@\w\+/
syn region gliftString start=/"/ skip=/\\./ end=/"\|$/ contains=gliftEscape oneline
syn match gliftEscape /\\./ contained
syn match gliftComment /\/\/.*$/ contains=gliftTodo,@Spell
syn match gliftDocumentation /\/\/\/\%(\/\)\@!.*$/ contains=@Spell
syn region gliftComment start=/\/\*/ end=/\*\// contains=gliftTodo,@Spell
syn keyword gliftTodo TODO FIXME contained

hi def link gliftKeyword Keyword
hi def link gliftControl Statement
hi def link gliftConstant Constant
hi def link gliftType Type
hi def link gliftFunction Function
hi def link gliftDirection StorageClass
hi def link gliftPattern StorageClass
hi def link gliftNumber Number
hi def link gliftAttribute PreProc
hi def link gliftString String
hi def link gliftEscape SpecialChar
hi def link gliftComment Comment
hi def link gliftDocumentation SpecialComment
hi def link gliftTodo Todo

let b:current_syntax = "glift"
