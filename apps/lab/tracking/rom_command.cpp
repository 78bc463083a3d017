#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/tracker_file.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

namespace rom_option
{
constexpr Option kNew{"new", "", "make a definition instead of reading one: a reference"};
constexpr Option kMarker{"marker", "X,Y,Z",
                         "of the one that is made, mm; X,Y,Z,NX,NY,NZ for one that faces that way. "
                         "Given for each marker",
                         true};
constexpr Option kSet{"set", "KEY=VALUE",
                      "change what is printed as KEY: kind, maker (at most 12 characters), "
                      "part_number (20), fewest_markers (3 to all), largest_error_mm (above 0 to "
                      "100), largest_angle_deg (1 to 180, whole) or smallest_spread_mm (0 to "
                      "4000). Given for each change",
                      true};
constexpr Option kSave{"save", "NEW", "write it as this file, of which there must be none yet"};
} // namespace rom_option

namespace rom_key
{
constexpr Key kFile{"file", "FILE as given; NEW where it was saved"};
constexpr Key kKind{"kind", "what the tool is for"};
constexpr Key kMaker{"maker", "who made the tool, as the file says"};
constexpr Key kPart{"part_number", "of the tool at its maker"};
constexpr Key kFewest{"fewest_markers", "that a pose needs"};
constexpr Key kError{"largest_error_mm", "of a marker that is used for a pose"};
constexpr Key kAngle{"largest_angle_deg", "between the normal of a marker and the camera"};
constexpr Key kSpread{"smallest_spread_mm", "extent that the markers used for a pose must have"};
constexpr Key kMarkers{"markers", "one object for each, in the order of the file:"};
constexpr Key kPosition{"p_mm", "[x, y, z] in the frame of the tool", 1};
constexpr Key kNormal{"normal", "where it faces; null where it is seen from everywhere", 1};
constexpr Key kSchema{"schema", "carina.rom/1"};
} // namespace rom_key

QJsonArray numbersOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

QJsonObject objectOf(const NdiToolDefinition& tool, const QString& file)
{
    QJsonArray markers;
    for (const ToolMarker& marker : tool.markers())
        markers.append(QJsonObject{
            {rom_key::kPosition, numbersOf(marker.p_OQ.unaryExpr(
                                     [](double length) { return inMillimetres(metres(length)); }))},
            {rom_key::kNormal,
             marker.normal_O.isZero() ? QJsonValue{} : QJsonValue{numbersOf(marker.normal_O)}}});
    return {{rom_key::kSchema, QLatin1StringView{rom_key::kSchema.help}},
            {rom_key::kFile, file},
            {rom_key::kKind, QString::fromStdString(kindName(tool.kind()))},
            {rom_key::kMaker, QString::fromStdString(tool.maker())},
            {rom_key::kPart, QString::fromStdString(tool.partNumber())},
            {rom_key::kFewest, qint64(tool.fewestMarkers())},
            {rom_key::kError, inMillimetres(tool.largestMarkerError())},
            {rom_key::kAngle, inDegrees(tool.largestMarkerAngle())},
            {rom_key::kSpread, inMillimetres(tool.smallestSpread())},
            {rom_key::kMarkers, markers}};
}

using RomFacts = NdiToolDefinition::Facts;

/// @returns false where it is no number.
template <class Value> bool putNumber(Value& value, Value (*inUnit)(double), const QString& text)
{
    bool isNumber = false;
    value = inUnit(text.toDouble(&isNumber));
    return isNumber;
}

bool putWhole(std::uint32_t& number, const QString& text)
{
    bool isWhole = false;
    number = text.toUInt(&isWhole);
    return isWhole;
}

bool putKind(std::uint8_t& kind, const QString& text)
{
    const auto named = kindOfName(text.toStdString());
    kind = named.value_or(0);
    return named.has_value();
}

bool putText(std::string& fact, const QString& text)
{
    fact = text.toStdString();
    return true;
}

/// A fact by the key that it is printed under; `put` says whether the text is of its type.
struct RomFact {
    Key key;
    bool (*put)(RomFacts& facts, const QString& text);
};

constexpr RomFact kRomFacts[] = {
    {rom_key::kKind, [](RomFacts& f, const QString& text) { return putKind(f.kind, text); }},
    {rom_key::kMaker, [](RomFacts& f, const QString& text) { return putText(f.maker, text); }},
    {rom_key::kPart, [](RomFacts& f, const QString& text) { return putText(f.partNumber, text); }},
    {rom_key::kFewest,
     [](RomFacts& f, const QString& text) { return putWhole(f.fewestMarkers, text); }},
    {rom_key::kError,
     [](RomFacts& f, const QString& text) {
         return putNumber(f.largestMarkerError, millimetres, text);
     }},
    {rom_key::kAngle,
     [](RomFacts& f, const QString& text) {
         return putNumber(f.largestMarkerAngle, degrees, text);
     }},
    {rom_key::kSpread, [](RomFacts& f, const QString& text) {
         return putNumber(f.smallestSpread, millimetres, text);
     }}};

Result<void> setFact(const Words& words, RomFacts& facts, const QString& change)
{
    const qsizetype equals = change.indexOf(QLatin1Char('='));
    const QString key = change.left(equals);
    const QString text = change.mid(equals + 1);
    const auto* fact = std::ranges::find_if(
        kRomFacts, [&](const RomFact& each) { return key == QLatin1StringView{each.key.name}; });
    if (equals < 0 || fact == std::end(kRomFacts))
        return words.refuse(QStringLiteral("cannot set '%1'.").arg(change));
    if (fact->put(facts, text))
        return {};
    const QString kinds =
        key == QLatin1StringView{rom_key::kKind.name}
            ? QStringLiteral(": it is one of ") + QString::fromStdString(kindNames())
            : QString{};
    return words.refuse(QStringLiteral("has no %1 '%2'%3.").arg(key, text, kinds));
}

Result<NdiToolDefinition> changedTool(const Words& words, const NdiToolDefinition& tool)
{
    if (!words.has(rom_option::kSet))
        return tool;
    RomFacts facts = tool.facts();
    for (const QString& change : words.texts(rom_option::kSet))
        if (const auto isSet = setFact(words, facts, change); !isSet)
            return tl::unexpected(isSet.error());
    return tool.with(facts);
}

Result<ToolMarker> markerOf(const Words& words, const QString& text)
{
    Eigen::Matrix<double, 6, 1> numbers = Eigen::Matrix<double, 6, 1>::Zero();
    const QStringList parts = text.split(QLatin1Char{','});
    bool isGood = parts.size() == 3 || parts.size() == 6;
    for (qsizetype i = 0; isGood && i < parts.size(); ++i)
        numbers[i] = parts[i].toDouble(&isGood);
    if (!isGood || !numbers.allFinite())
        return words.refuse(QStringLiteral("has no marker '%1'.").arg(text));
    return ToolMarker{millimetres(1.0).si * numbers.head<3>(), numbers.tail<3>().normalized()};
}

Result<NdiToolDefinition> newTool(const Words& words)
{
    std::vector<ToolMarker> markers;
    for (const QString& text : words.texts(rom_option::kMarker)) {
        const auto marker = markerOf(words, text);
        if (!marker)
            return tl::unexpected(marker.error());
        markers.push_back(*marker);
    }
    return NdiToolDefinition::make(NdiToolDefinition::Kind::Reference, markers, "Carina", "tool");
}

Result<NdiToolDefinition> chosenTool(const Words& words)
{
    if (words.has(rom_option::kNew) == !words.files().isEmpty())
        return words.refuse(QStringLiteral("needs FILE or --new, and not both."));
    if (words.has(rom_option::kNew))
        return newTool(words);
    if (words.has(rom_option::kMarker))
        return words.refuse(QStringLiteral("takes --marker with --new only."));
    return readToolDefinition(words.files().front().toStdString());
}

/// Under a name that no file has yet.
Result<void> saveTool(const std::filesystem::path& file, const NdiToolDefinition& tool)
{
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored))
        return fail(Errc::FileUnwritable,
                    file.string() + ": there is such a file; choose another name");
    const auto& bytes = tool.bytes();
    return writeWholeFile(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<QJsonObject> describe(const Words& words)
{
    const bool isSaved = words.has(rom_option::kSave);
    if (!isSaved && (words.has(rom_option::kSet) || words.has(rom_option::kNew)))
        return words.refuse(QStringLiteral("needs --save NEW."));
    const auto tool = chosenTool(words).and_then(
        [&](const NdiToolDefinition& chosen) { return changedTool(words, chosen); });
    if (!tool)
        return tl::unexpected(tool.error());
    const QString file = isSaved ? words.text(rom_option::kSave) : words.files().front();
    if (isSaved)
        if (const auto saved = saveTool(file.toStdString(), *tool); !saved)
            return tl::unexpected(saved.error());
    return objectOf(*tool, file);
}

} // namespace

Command romCommand()
{
    using namespace rom_option;
    return {
        .name = "rom",
        .theme = "tracking",
        .summary = "describes, changes or makes a tool definition of NDI",
        .uses = {{.lines = {"FILE [--set KEY=VALUE --save NEW]",
                            "--new --marker X,Y,Z [--set KEY=VALUE] --save NEW"},
                  .text =
                      "Reads a tool definition of NDI (.rom) or makes one, checks it, and prints "
                      "the markers of the tool. What is not changed stays byte for byte; a "
                      "change that no pose could follow is refused, and then nothing is "
                      "written.",
                  .notes = {{"rom old.rom --set part_number=7 --save new.rom",
                             "the same tool under another number"}},
                  .options = {kNew, kMarker, kSet, kSave},
                  .schema = rom_key::kSchema,
                  .keys = {rom_key::kFile, rom_key::kKind, rom_key::kMaker, rom_key::kPart,
                           rom_key::kFewest, rom_key::kError, rom_key::kAngle, rom_key::kSpread,
                           rom_key::kMarkers, rom_key::kPosition, rom_key::kNormal}}},
        .mostFiles = 1,
        .reminder = "rom needs FILE, or --new with three markers.",
        .experiment = describe};
}

} // namespace carina::lab
