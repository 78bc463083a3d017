#pragma once

#include "engine/tracking/igtl/igtl_bytes.h"
#include "engine/tracking/igtl/igtl_message.h"

namespace carina
{

// Contents as bytes, for igtl_codec.cpp only. Reading takes all bytes that there are.

[[nodiscard]] IgtlPolyData readPolyData(IgtlBytes& bytes);
void writePolyData(IgtlWriter& out, const IgtlPolyData& data);

/// @pre isReadIgtlType(type), and it is not POLYDATA
[[nodiscard]] IgtlContent readSmallContent(const std::string& type, IgtlBytes& bytes);
/// @pre it is neither a surface nor skipped
void writeSmallContent(IgtlWriter& out, const IgtlContent& content);

} // namespace carina
