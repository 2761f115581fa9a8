// The text of lowered passes, as print.h writes it, read back: for tests of single passes over the IR.
//
//     pass      = "pass" name form "{" { header } { function } { section } "}" ;
//     header    = "group" n n n "," "rank" n [ "," "items" n ] [ "," "takes" n n n ] [ "," "declared" ]
//               | "loops" ( n | "unbounded" ) | "reports" | "inexact"
//               | "struct" type "{" [ field { "," field } ] "}" | "enum" type "{" [ name "=" n { "," name "=" n } ] "}"
//               | "value" name ":" type | "structure" name
//               | "binding" name ":" shape "<" type ">" access { word } "of" place n [ "at" parameter ]
//               | "parameter" name ":" type "=" ( expr | "origin" name | "size" | "range_size" name | "address" name )
//               | "shared" name ":" type | "address" name ":" type | "in_range" name | "fact" expr ;
//     function  = "fn" "@" name "(" [ name ":" type { "," name ":" type } ] ")" "->" type "{" { statement } "}" ;
//     section   = ( "prologue" | "body" | "two elements" | "interior" n parameter parameter ) { statement } ;
//     statement = ( "let" | "tmp" | "var" ) name ":" type [ "=" ( expr | "uninitialized" ) ] ";"
//               | "if" expr "{" … "}" [ "else" "{" … "}" ] | [ "unrolled" ] "for" name ":" type "in" operand ".."
//               operand "{" … "}" | "while" expr "{" … "}" | "{" … "}" | "break" ";" | "continue" ";" | "return" [ expr
//               ] ";" | "barrier()" ";" | "subgroupBarrier()" ";" | expr "=" expr ";" | expr ";" | "image_store("
//               binding "," expr "," expr ")" ";" | "atomic_…(" expr "," expr ")" ";" | "report(" … ")" ";" ;
//     expr      = operand [ operator operand ] | operand "?" operand ":" operand ;
//     operand   = [ "-" | "!" | "~" ] primary { "." name | "[" expr "]" } ;
//     primary   = literal | local | "$" parameter | "%" builtin | type "(" … ")" | intrinsic "(" … ")" | "@" function
//     "(" … ")"
//               | binding "[" expr "]" | "image_load(" … ")" | "image_sample(" … ")" | place | "none" | "(" expr [ ":"
//               type ] ")" ;
//
// A type stands behind an expression where its operands do not imply it (ir/implied_type.h). "tmp" is a let that a pass
// made for a value. "fact" says a condition that holds on the whole body; only tests write it.
#pragma once

#include "ir/pass.h"

#include <stdexcept>
#include <string_view>
#include <vector>

namespace gliftc::ir {

/// The text is not that of a pass. what() says the line, and what was expected there.
struct ReadError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ReadPass {
    Pass pass;  ///< pass.kernel is a kernel of the program with the parameters that the text names
    std::vector<ExprId> facts;
};

/// Reads the passes of a text, one after the other. Adds to the program what they consist of.
std::vector<ReadPass> read_passes(Program& program, std::string_view text);

}  // namespace gliftc::ir
