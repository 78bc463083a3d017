#pragma once

#include "engine/io/anatomy_set/set_corrections.h"
#include "engine/io/anatomy_set/set_folder.h"

namespace carina
{

/// Makes a patient of a folder's surfaces, without any cache.
///
/// Every surface gets a role by its concept or its name, or by its file's name. The review, where
/// there is one, sees that and corrects it. What is there twice is left out (see leaveOutRepeated).
/// Unit and axes are found (see findSetFrame) where they were not given, and all is moved into A:
/// metres, origin at the carina, or at the middle of the set where no trachea tells it. Lungs and
/// lobes are welded within 10 um, capped and turned outward; each part gets levels of detail. A
/// file that cannot be used is among the faults, and the rest is imported. The result depends on
/// the files alone; its name and content hash are left empty.
///
/// @returns NothingRecognised when no surface has a role; OutOfRange when no unit fits; Cancelled.
[[nodiscard]] Result<ImportedSet> importSetFolder(const SetFolder& folder,
                                                  const ImportProgress& progress,
                                                  const SetReview& review = {});

} // namespace carina
