#pragma once

#include <Cutwater/Text/ByteCursor.hpp>
#include <Cutwater/Text/Output.hpp>
#include <Cutwater/Text/TextCursor.hpp>
#include <Cutwater/Text/Words.hpp>

// Readers and writers use the names of Text/ without a prefix.
namespace cutwater::formats {

using text::ByteCursor;
using text::Content;
using text::Cursor;
using text::equalIgnoringCase;
using text::inQuotes;
using text::isInteger;
using text::Output;
using text::Place;
using text::ScalarType;
using text::sizeOf;
using text::TextCursor;

}  // namespace cutwater::formats
