// seeds DIR: whole messages for the fuzzers to begin with, in a folder below DIR for each.

#include "engine/io/anatomy_set/set_codec.h"
#include "engine/net/discovery/session_notice.h"
#include "engine/net/entry/join_link.h"
#include "engine/net/entry/role_proof.h"
#include "engine/net/entry/token_message.h"
#include "engine/net/secure/dtls_record.h"
#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/engine/io/mesh/texture_files.h"
#include "tests/engine/io/site/landmark_samples.h"
#include "tests/engine/net/anatomy_transfer/frame_samples.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/fuzz/set_under_seal.h"

#include <fstream>

namespace
{

using namespace carina;

const std::string kSession = "00112233445566778899aabbccddeeff";

std::string textOf(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string> datagrams()
{
    const std::string header = textOf(fromHex(kGoldenHeaderHex));
    std::vector<std::string> all;
    for (const GoldenRecord& golden : goldenRecords())
        all.push_back(header + textOf(fromHex(golden.hex)));
    return all;
}

/// A record of DTLS, RFC 6347, 4.1.
std::string dtls(char type, char epoch, const std::string& fragment)
{
    return std::string{type, '\xFE', '\xFD', 0, epoch, 0, 0, 0, 0, 0, 0, 0}
           + static_cast<char>(fragment.size()) + fragment;
}

std::vector<std::string> entries()
{
    const AccessKey key = *keyFromHex(std::string(64, '7'));
    const PskIdentity newcomer{{Role::Trainee, std::nullopt}, kSession};
    const PskIdentity anna{{Role::Observer, ParticipantId{7}}, kSession};
    JoinLink link{"192.0.2.7", 45000, Role::Observer, *JoinCode::parse("7K3QMXW2PD")};
    std::vector<std::string> all{toText(link), link.code.text(), toText(newcomer), toText(anna)};
    link.certificate = "carina.example";
    all.push_back(toText(link));
    const std::vector<std::vector<std::byte>> messages{
        encodeQuestion(7),
        encodeAnswer(0, {goldenKey(), "Ward 3", 45000}),
        encodeToken({ParticipantId{7}, key}),
        encodeChallenge({kSession, key}),
        encodeProof({anna, key}),
        encodeProof({newcomer, key}),
        encodeVerdict(true),
        encodeVerdict(false)};
    for (const auto& message : messages)
        all.push_back(textOf(message));
    all.push_back(textOf(std::as_bytes(wrongKeyAlert())));
    all.push_back(dtls(21, 0, {2, 40}));
    all.push_back(dtls(22, 0, {1, 0, 0}));
    all.push_back(dtls(22, 0, {16, 0, 0}) + dtls(20, 0, {1}) + dtls(22, 1, "finished"));
    return all;
}

std::vector<std::string> frames()
{
    std::vector<std::string> all(1);
    for (const test::GoldenFrame& golden : test::goldenFrames()) {
        all.push_back(golden.bytes);
        all.front() += golden.bytes;
    }
    return all;
}

std::vector<std::string> sets()
{
    const auto withoutSeal = [](const ImportedSet& set) {
        return textOf(encodeSet(set)).substr(fuzz::kSealBytes);
    };
    ImportedSet painted = test::carriedSample();
    for (AnatomyPart& part : painted.anatomy.parts)
        for (const TriangleMesh& level : part.levels)
            part.colors.emplace_back(level.positions.size(), Rgb{200, 120, 90});
    return {withoutSeal(test::carriedSample()), withoutSeal(painted), withoutSeal({})};
}

std::vector<std::string> pictures()
{
    constexpr int kSide = 16;
    const auto pixels = test::pixelsOf(kSide, [](double u, double v) {
        return test::Pixel{static_cast<unsigned char>(255 * u), static_cast<unsigned char>(255 * v),
                           9};
    });
    return {test::pngOf(kSide, pixels), test::jpegOf(kSide, pixels)};
}

/// The first byte chooses the decoder.
std::vector<std::string> landmarks()
{
    return {"0" + test::kLandmarkTable, "1" + test::kSlicerPoints, "1" + test::kSlicerPointsRas,
            "2" + test::kSlicerMarkups, "2" + test::kSlicerMarkupsRas};
}

/// In front of the messages two bytes, which say how they are read.
std::vector<std::string> igtl()
{
    std::vector<std::string> all{std::string{"\1\1"}};
    for (const IgtlMessage& message : test::igtlSamples()) {
        all.push_back("\1\1" + textOf(encodeIgtl(message)));
        all.front() += textOf(encodeIgtl(message));
    }
    return all;
}

bool areWritten(const std::filesystem::path& folder, const std::vector<std::string>& all)
{
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& bytes : all) {
        std::ofstream file{folder / std::to_string(++number), std::ios::binary};
        if (!(file << bytes))
            return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    const std::filesystem::path folder{argv[1]};
    const bool written =
        areWritten(folder / "datagram", datagrams()) && areWritten(folder / "entry", entries())
        && areWritten(folder / "transfer", frames()) && areWritten(folder / "set", sets())
        && areWritten(folder / "igtl", igtl()) && areWritten(folder / "landmark", landmarks())
        && areWritten(folder / "picture", pictures());
    return written ? 0 : 1;
}
