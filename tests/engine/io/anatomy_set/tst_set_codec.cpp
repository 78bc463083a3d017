#include "engine/io/anatomy_set/set_codec.h"
#include "tests/support/test_class.h"

#include <QCryptographicHash>

#include <cmath>
#include <cstring>
#include <random>

namespace carina::set_codec_test
{
namespace
{

ImportedSet smallSet()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    TriangleMesh smooth = mesh;
    computeNormals(smooth);
    ImportedSet set;
    set.anatomy.name = "Adult";
    set.anatomy.contentHash = std::string(64, 'a');
    set.anatomy.parts = {{"Trachea", PartRole::Trachea, "FMA7394", {smooth, mesh}, {0.0, 5e-4}},
                         {"Right lung", PartRole::RightLung, "", {mesh}}};
    const Rgb pink{230, 160, 150};
    set.anatomy.parts[0].colors = {{pink, {1, 2, 3}, pink, pink}, std::vector(4, Rgb{0, 128, 255})};
    set.anatomy.landmarks.p_A_incisors = {0.0, -0.08, 0.2};
    set.anatomy.landmarks.p_A_glottis = {0.0, -0.01, 0.12};
    set.anatomy.landmarks.path_A = {{0.0, -0.08, 0.2}, {0.0, 0.0, 0.0}};
    set.anatomy.attributions = {"CC BY-SA 2.1 JP"};
    set.frame.metresPerUnit = 0.01;
    set.frame.R_AF = -Mat3::Identity();
    set.faults = {{"a.obj", {Errc::FileEmpty, "a.obj: it is empty"}}};
    set.leftOut = {"b.obj: Hyoid bone"};
    return set;
}

bool same(const TriangleMesh& a, const TriangleMesh& b)
{
    return a.positions == b.positions && a.normals == b.normals && a.triangles == b.triangles;
}

constexpr std::size_t kHeaderBytes = 52;

/// The header's length and checksum made to fit a payload that was tampered with.
void seal(std::vector<std::byte>& bytes)
{
    const std::uint64_t length = bytes.size() - kHeaderBytes;
    std::memcpy(bytes.data() + 12, &length, sizeof length);
    QCryptographicHash hash{QCryptographicHash::Blake2b_256};
    hash.addData(QByteArrayView{bytes.data() + kHeaderBytes, static_cast<qsizetype>(length)});
    std::memcpy(bytes.data() + 20, hash.result().constData(), 32);
}

} // namespace

class TestSetCodec final : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesBackWhatWasWritten()
    {
        const ImportedSet before = smallSet();
        const auto after = decodeSet(encodeSet(before));
        QVERIFY2(after.has_value(), after ? "" : after.error().detail.c_str());
        QCOMPARE(after->anatomy.name, before.anatomy.name);
        QCOMPARE(after->anatomy.contentHash, before.anatomy.contentHash);
        QCOMPARE(after->anatomy.parts.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
            const AnatomyPart& a = after->anatomy.parts[i];
            const AnatomyPart& b = before.anatomy.parts[i];
            QCOMPARE(a.name, b.name);
            QVERIFY(a.role == b.role);
            QCOMPARE(a.conceptId, b.conceptId);
            QCOMPARE(a.levels.size(), b.levels.size());
            QCOMPARE(a.deviations, b.deviations);
            QVERIFY(a.colors == b.colors);
            for (std::size_t level = 0; level < a.levels.size(); ++level)
                QVERIFY(same(a.levels[level], b.levels[level]));
        }
        QVERIFY(after->anatomy.landmarks.p_A_incisors == before.anatomy.landmarks.p_A_incisors);
        QVERIFY(after->anatomy.landmarks.p_A_glottis == before.anatomy.landmarks.p_A_glottis);
        QVERIFY(after->anatomy.landmarks.p_A_carina == before.anatomy.landmarks.p_A_carina);
        QVERIFY(after->anatomy.landmarks.path_A == before.anatomy.landmarks.path_A);
        QCOMPARE(after->anatomy.attributions, before.anatomy.attributions);
        QCOMPARE(after->frame.metresPerUnit, before.frame.metresPerUnit);
        QVERIFY(after->frame.R_AF == before.frame.R_AF);
        QCOMPARE(after->faults.size(), std::size_t{1});
        QCOMPARE(after->faults[0].file, before.faults[0].file);
        QVERIFY(after->faults[0].error == before.faults[0].error);
        QCOMPARE(after->leftOut, before.leftOut);
    }

    void laysTheHeaderOutAsDocumented()
    {
        const auto bytes = encodeSet(smallSet());
        QVERIFY(std::memcmp(bytes.data(), "CARINAPT\7\0\0\0", 12) == 0);
        std::uint64_t length = 0;
        std::memcpy(&length, bytes.data() + 12, sizeof length);
        QCOMPARE(length, std::uint64_t{bytes.size() - kHeaderBytes});
    }

    void refusesEveryTruncation()
    {
        const auto bytes = encodeSet(smallSet());
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const auto set = decodeSet(std::span{bytes}.first(length));
            QVERIFY2(!set && set.error().code == Errc::FileMalformed,
                     std::to_string(length).c_str());
        }
    }

    void refusesListsBeyondTheirLimits()
    {
        ImportedSet set = smallSet();
        set.anatomy.parts[1].levels.resize(16, set.anatomy.parts[1].levels[0]);
        QVERIFY(decodeSet(encodeSet(set)).has_value());
        set.anatomy.parts[1].levels.resize(17, set.anatomy.parts[1].levels[0]);
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
        set = smallSet();
        set.leftOut.resize(32'768);
        QVERIFY(decodeSet(encodeSet(set)).has_value());
        set.leftOut.resize(32'769);
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
    }

    void refusesDeviationsThatAreNone_data()
    {
        QTest::addColumn<std::vector<double>>("deviations");
        QTest::newRow("one for two levels") << std::vector<double>{0.0};
        QTest::newRow("negative") << std::vector<double>{0.0, -1e-9};
        QTest::newRow("not a number") << std::vector<double>{0.0, std::nan("")};
        QTest::newRow("infinite") << std::vector<double>{0.0,
                                                         std::numeric_limits<double>::infinity()};
    }

    void refusesDeviationsThatAreNone()
    {
        ImportedSet set = smallSet();
        QFETCH(std::vector<double>, deviations);
        set.anatomy.parts[0].deviations = deviations;
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
    }

    void refusesColoursThatFitNoMesh()
    {
        ImportedSet set = smallSet();
        set.anatomy.parts[0].colors.pop_back();
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
        set = smallSet();
        set.anatomy.parts[0].colors[1].pop_back();
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
        set = smallSet();
        set.anatomy.parts[1].colors = {set.anatomy.parts[0].colors[0], {}};
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
    }

    void refusesAMeshThatContradictsItself()
    {
        ImportedSet set = smallSet();
        set.anatomy.parts[1].levels[0].triangles[3][2] = 4;
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
        set = smallSet();
        set.anatomy.parts[0].levels[0].normals.pop_back();
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
        set = smallSet();
        set.anatomy.parts[0].levels.clear();
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
        set = smallSet();
        set.anatomy.landmarks.p_A_glottis.x() = std::nan("");
        QVERIFY(!decodeSet(encodeSet(set)).has_value());
    }

    void refusesATruncationUnderAGoodChecksum()
    {
        const auto bytes = encodeSet(smallSet());
        for (std::size_t length = kHeaderBytes; length < bytes.size(); ++length) {
            std::vector<std::byte> cut{bytes.begin(), bytes.begin() + static_cast<long>(length)};
            seal(cut);
            QVERIFY2(!decodeSet(cut).has_value(), std::to_string(length).c_str());
        }
    }

    void survivesAnyDamageUnderAGoodChecksum()
    {
        const auto bytes = encodeSet(smallSet());
        std::mt19937 random{3};
        for (int round = 0; round < 5000; ++round) {
            auto damaged = bytes;
            for (int i = 0; i < 1 + round % 3; ++i)
                damaged[kHeaderBytes + random() % (bytes.size() - kHeaderBytes)] =
                    static_cast<std::byte>(round % 2 == 0 ? random() % 256 : 0xff);
            seal(damaged);
            const auto set = decodeSet(damaged);
            if (!set)
                continue;
            for (const AnatomyPart& part : set->anatomy.parts)
                for (const TriangleMesh& level : part.levels)
                    for (const Triangle& t : level.triangles)
                        for (const std::uint32_t corner : t)
                            QVERIFY(corner < level.positions.size());
        }
    }

    void refusesEveryChangedByteAndWhatFollows()
    {
        auto bytes = encodeSet(smallSet());
        for (std::byte& b : bytes) {
            b ^= std::byte{0x10};
            QVERIFY(!decodeSet(bytes).has_value());
            b ^= std::byte{0x10};
        }
        QVERIFY(decodeSet(bytes).has_value());
        bytes.push_back(std::byte{0});
        QVERIFY(!decodeSet(bytes).has_value());
    }
};

CARINA_TEST(TestSetCodec)

} // namespace carina::set_codec_test

#include "tst_set_codec.moc"
