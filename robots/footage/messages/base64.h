// SPDX-License-Identifier: MIT
// Decodes base64 (RFC 4648).
#pragma once

#include <string_view>

#include "robots/footage/messages/messages.h"

namespace reorient::messages {

/// The padding at the end may be missing. Throws BadFootage with the offset of the first invalid letter.
Bytes bytes_of_base64(std::string_view text);

}  // namespace reorient::messages
