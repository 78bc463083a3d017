#pragma once

#include "engine/anatomy/anatomy.h"

#include <string>

namespace carina::test
{

/// Made patients by the name of a row: "man", "woman", "12 years", "6 years"; each is made once.
const Anatomy& personCalled(const std::string& name);

/// The rows of all of them, in a column "name".
void people();

/// The finest surface of a part. @pre the patient has it.
const TriangleMesh& named(const Anatomy& anatomy, const std::string& part);

/// How many vertices of a surface lie within another one, which is closed, and how many outside.
/// What the nearest triangle faces decides, and the winding number where it would count.
int verticesWithin(const TriangleMesh& surface, const TriangleMesh& other);
int verticesOutside(const TriangleMesh& surface, const TriangleMesh& other);

} // namespace carina::test
