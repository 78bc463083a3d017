#pragma once

#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"

#include <QJsonArray>
#include <QJsonObject>

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// Reads the fields of a JSON object one by one and remembers the first fault, its own or of an
/// object within, as FileMalformed "touched[2].p_TQ_mm: three numbers are due". A field with a
/// fault reads as zero, so that a reader asks for all it needs and looks for a fault once, at the
/// end. Lengths are millimetres in the file and metres here.
class JsonFields
{
public:
    /// @param fault takes the first fault; outlives this.
    /// @param path  where the object stands in its file, empty for the outermost
    JsonFields(QJsonObject object, std::optional<Error>& fault, std::string path = {});

    /// A key that is not among these is a fault: a misspelled one would be lost.
    void allowOnly(std::initializer_list<const char*> keys);

    [[nodiscard]] bool has(const char* key) const;
    /// A text that is not empty.
    [[nodiscard]] std::string text(const char* key);
    /// A text that is not empty, or the first of a list of texts.
    [[nodiscard]] std::string firstText(const char* key);
    /// Not negative.
    [[nodiscard]] double length(const char* key);
    /// A number from 0 to a million.
    [[nodiscard]] double amount(const char* key);
    /// So many numbers, each below a million.
    [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count);
    /// A whole number from 0 to a million.
    [[nodiscard]] int count(const char* key);
    /// The place of a text among these words.
    [[nodiscard]] std::size_t oneOf(const char* key, std::span<const char* const> words);
    /// [x, y, z], each below a kilometre.
    [[nodiscard]] Vec3 point(const char* key);
    /// Four rows of four numbers: a proper rotation, and a translation below a kilometre.
    [[nodiscard]] RigidTransform pose(const char* key);
    [[nodiscard]] JsonFields object(const char* key);
    [[nodiscard]] std::vector<JsonFields> objects(const char* key);

    /// Marks a field as faulty for a reason of the caller's.
    void refuse(const char* key, const std::string& why);

private:
    [[nodiscard]] std::string placeOf(const std::string& key) const;

    QJsonObject m_object;
    std::optional<Error>* m_fault;
    std::string m_path;
};

/// A point as [x, y, z] in millimetres.
[[nodiscard]] QJsonArray jsonPoint(const Vec3& p);

/// A pose as four rows of four numbers, its translation in millimetres.
[[nodiscard]] QJsonArray jsonPose(const RigidTransform& X);

/// The object that a JSON text holds; an empty one for a list.
/// @returns FileMalformed where it is no JSON.
[[nodiscard]] Result<QJsonObject> jsonObjectIn(std::string_view text);

/// The object that a JSON file holds, of which "schema" is as given.
/// @returns FileNotFound, FileUnreadable, FileEmpty; FileMalformed where it is no JSON object;
///          UnknownFormat where its schema is another. The detail begins with the file.
[[nodiscard]] Result<QJsonObject> readJsonFile(const std::filesystem::path& file,
                                               const QString& schema);

/// Writes an object so that the file is either there whole or as it was, whenever the program is
/// killed.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeJsonFile(const std::filesystem::path& file,
                                         const QJsonObject& object);

} // namespace carina
