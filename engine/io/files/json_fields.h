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

/// Reads the fields of a JSON object one by one and keeps the first fault, its own or of a nested
/// object, as FileMalformed "touched[2].p_TQ_mm: three numbers are due". A field with a fault reads
/// as zero, so that a reader can read all fields and check once at the end. Lengths are millimetres
/// in the file and metres here.
class JsonFields
{
public:
    /// @param fault receives the first fault; must outlive this.
    /// @param path  of the object within its file, empty for the outermost
    JsonFields(QJsonObject object, std::optional<Error>& fault, std::string path = {});

    /// A key that is not among these is a fault, so that a misspelled key is not ignored.
    void allowOnly(std::initializer_list<const char*> keys);

    [[nodiscard]] bool has(const char* key) const;
    /// A text, not empty.
    [[nodiscard]] std::string text(const char* key);
    /// A text, not empty, or the first of a list of texts.
    [[nodiscard]] std::string firstText(const char* key);
    /// A length in metres, not negative.
    [[nodiscard]] double length(const char* key);
    /// A number from 0 to a million.
    [[nodiscard]] double amount(const char* key);
    /// A number below a million, of either sign.
    [[nodiscard]] double number(const char* key);
    /// A list of exactly `count` numbers, each below a million.
    [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count);
    /// A whole number from 0 to a million.
    [[nodiscard]] int count(const char* key);
    /// true or false.
    [[nodiscard]] bool truth(const char* key);
    /// The index of a text in `words`.
    [[nodiscard]] std::size_t oneOf(const char* key, std::span<const char* const> words);
    /// [x, y, z], each below a kilometre; in metres.
    [[nodiscard]] Vec3 point(const char* key);
    /// Four rows of four numbers: a proper rotation, and a translation below a kilometre.
    [[nodiscard]] RigidTransform pose(const char* key);
    [[nodiscard]] JsonFields object(const char* key);
    [[nodiscard]] std::vector<JsonFields> objects(const char* key);

    /// Reports a fault of a field, with the caller's reason.
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

/// The object in a JSON text; an empty one for a list.
/// @returns FileMalformed where it is not JSON.
[[nodiscard]] Result<QJsonObject> jsonObjectIn(std::string_view text);

/// The object in a JSON file whose "schema" must be as given.
/// @returns FileNotFound, FileUnreadable, FileEmpty, FileTooLarge; FileMalformed where it is not a
/// JSON object;
///          UnknownFormat where its schema is another. The detail begins with the file.
[[nodiscard]] Result<QJsonObject> readJsonFile(const std::filesystem::path& file,
                                               const QString& schema);

/// Writes an object. If the program is killed meanwhile, the file is the old or the new one, whole.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeJsonFile(const std::filesystem::path& file,
                                         const QJsonObject& object);

} // namespace carina
