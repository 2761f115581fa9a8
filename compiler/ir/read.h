// Parses the text of lowered passes, as print.h writes it: for tests of single passes over the IR.
//
//     pass      = "pass" name form "{" { header | function } { section } "}" ;
//     header    = "group" n n n "," "rank" n { "," ( "items" n | "declared" ) }
//               | "loops" ( n | "unbounded" ) | "reports" | "inexact"
//               | "struct" type "{" [ field { "," field } ] "}" | "enum" type "{" [ name "=" n { "," name "=" n } ] "}"
//               | "value" name ":" type | "structure" name | "given" name ":" type
//               | "binding" name ":" shape "<" type ">" access { word } "of" place n [ "at" "$" parameter ]
//               | "parameter" name ":" type "=" source
//               | "shared" name ":" type | "address" name ":" type | "in_range" name | "fact" expr ;
//     source    = expr | "origin" name | "size" | "range_size" name | "address" name | "index" name | "base" ;
//     function  = "fn" "@" name "(" [ name ":" type { "," name ":" type } ] ")" "->" type "{" { statement } "}" ;
//     section   = "prologue" { statement } | [ "block" { statement } ] variant { statement } ;
//     variant   = ( "body" | "vertex" | "fragment" ) { "," assumption } ;
//     assumption = "on" ( "shaders" | "host" ) | "takes" n n n | "rows of" n | "any order" | "in blocks"
//               | "inside" n "of" "$" parameter [ "from" "$" parameter ]
//               | "bounds" "(" expr "," ( expr | "any" ) "," ( expr | "any" ) ")" ;
//     statement = [ "keep" ] ( "let" | "tmp" | "var" ) name ":" type [ "=" ( expr | "uninitialized" ) ] ";"
//               | "if" expr "{" … "}" [ "else" "{" … "}" ] | "while" expr "{" … "}" | "{" … "}"
//               | [ "unrolled" ] "for" name ":" type "in" operand ".." operand "{" … "}"
//               | "break" ";" | "continue" ";" | "return" [ expr ] ";" | "discard" ";"
//               | "barrier()" ";" | "subgroupBarrier()" ";" | expr "=" expr ";" | expr ";"
//               | "image_store(" binding "," expr "," expr ")" ";" | "atomic_…(" binding "[" expr "]"
//                 "," expr ")" ";"
//               | "report(" … ")" ";" | "load_rows(" … ")" ";" | "store_rows(" … ")" ";" | "copy_row(" … ")" ";"
//               | "cut(" … ")" ";" | "invocations" "{" … "}" ;
//     expr      = operand [ operator operand ] | operand "?" operand ":" operand ;
//     operand   = { "-" | "!" | "~" } primary { "." name | [ ".row" ] "[" expr "]" } ;
//     primary   = literal | local | "$" parameter | "%" builtin | type "(" … ")" | enum "." name
//               | intrinsic "(" … ")" | "@" function "(" … ")" | binding [ ".row" ] "[" expr "]"
//               | "image_load(" … ")" | "image_sample(" … ")" | "image_gather(" … ")" | "image_compare(" … ")"
//               | "guarded_load(" … ")" | place "." property | "state" n | "none" | "(" expr [ ":" type ] ")" ;
//     property  = "domain" | "member" n | "memory" n | "host" n ;
//
// "declared": the source declares the group. "tmp" is a let that a pass of lower/ introduced; n counts from 0; place is
// a path from a kernel's parameter through nested members, such as f.table; "given" is a local that a draw exchanges
// with the rasteriser; intrinsic is also "some", "has_value" or "value", for optionals. A primary "(" expr ":" type ")"
// gives the type of an expression whose operands do not imply it (ir/implied_type.h). "fact" is a condition that is
// known to hold throughout the body; tests and --dump-after write it. "member" n is the n-th argument of the
// structure's constructor, "memory" n the extent of its n-th memory, "host" n the n-th host state of a container,
// "state" n the n-th scalar field of a translator; "of" place n names the n-th memory of the structure at the place,
// and each word before it sets a member of PassBinding, one_place and compare with the word after them (read_pass.cpp).
// "loops", "reports", "inexact" set members of Pass; "keep" marks locals whose values cross a barrier; the section
// "block" is Variant::block. "…": as print_statements.cpp and print_expressions.cpp write it.
#pragma once

#include "ir/pass.h"

#include <stdexcept>
#include <string_view>
#include <vector>

namespace gliftc::ir {

/// A syntax error. what() gives the line, and what was expected there.
struct ReadError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ReadPass {
    Pass pass;  ///< pass.kernel: a kernel that is added to the program, with the parameters that the text names
    std::vector<ExprId> facts;
};

/// Reads the passes of a text, and adds their kernels, structures, functions and expressions to the program.
std::vector<ReadPass> read_passes(Program& program, std::string_view text);

}  // namespace gliftc::ir
