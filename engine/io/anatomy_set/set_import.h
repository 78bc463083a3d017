#pragma once

#include "engine/io/anatomy_set/set_corrections.h"
#include "engine/io/anatomy_set/set_folder.h"

namespace carina
{

/// Imports a patient from the surfaces of a folder, without a cache.
///
/// Every surface gets a role by its concept id, its name or its file's name. The review, if any,
/// may correct it. Duplicates are left out (see leaveOutRepeated). Unit and axes are found (see
/// findSetFrame) unless corrected, and everything is transformed into A: metres, origin at the
/// carina, or at the middle of the set where no trachea determines it. Lungs and lobes are welded
/// within 10 um, capped and turned outward; each part gets levels of detail. A file that cannot be
/// used becomes a fault, and the rest is imported. The result depends on the files alone; its name
/// and content hash are left empty.
///
/// @returns NothingRecognised where no surface has a role; OutOfRange where no unit fits;
///          Cancelled.
[[nodiscard]] Result<ImportedSet> importSetFolder(const SetFolder& folder,
                                                  const ImportProgress& progress,
                                                  const SetReview& review = {});

} // namespace carina
