#include "engine/io/site/landmark_text.h"

#include "tests/engine/io/site/landmark_samples.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::damaged_landmarks_test
{
namespace
{

using Decode = Result<std::vector<Landmark>> (*)(std::string_view text);

Result<std::vector<Landmark>> decodeMarkups(std::string_view text)
{
    const auto catalogue = decodeSlicerMarkups(text);
    if (!catalogue)
        return tl::unexpected(catalogue.error());
    return catalogue->landmarks;
}

/// Whether a decoder either refuses a text, with a reason, or gives places in a room.
bool answersSoundly(Decode decode, const std::string& text)
{
    const auto landmarks = decode(text);
    if (!landmarks)
        return !landmarks.error().detail.empty();
    return std::ranges::all_of(*landmarks, [](const Landmark& landmark) {
        return landmark.p_AQ.allFinite() && landmark.p_AQ.cwiseAbs().maxCoeff() <= 1e3;
    });
}

} // namespace

/// The decoders of landmark files on damaged bytes: seeded, so that a failure can be had again.
class TestDamagedLandmarks : public QObject
{
    Q_OBJECT

private:
    static void addDecoders()
    {
        QTest::addColumn<Decode>("decode");
        QTest::addColumn<std::string>("sound");
        QTest::newRow("table") << &decodeLandmarkTable << test::kLandmarkTable;
        QTest::newRow("points") << &decodeSlicerPoints << test::kSlicerPoints;
        QTest::newRow("points in RAS") << &decodeSlicerPoints << test::kSlicerPointsRas;
        QTest::newRow("markups") << &decodeMarkups << test::kSlicerMarkups;
    }

private Q_SLOTS:
    void readsTheUndamagedText_data() { addDecoders(); }
    void readsTheUndamagedText()
    {
        QFETCH(Decode, decode);
        QFETCH(std::string, sound);
        const auto landmarks = decode(sound);
        QVERIFY(landmarks.has_value());
        QCOMPARE(landmarks->size(), 3U);
    }

    void staysSoundWhereItIsCutOff_data() { addDecoders(); }
    void staysSoundWhereItIsCutOff()
    {
        QFETCH(Decode, decode);
        QFETCH(std::string, sound);
        for (std::size_t length = 0; length < sound.size(); ++length)
            QVERIFY2(answersSoundly(decode, sound.substr(0, length)), sound.c_str());
    }

    void staysSoundWhereBytesAreChanged_data() { addDecoders(); }
    void staysSoundWhereBytesAreChanged()
    {
        QFETCH(Decode, decode);
        QFETCH(std::string, sound);
        std::mt19937 random{7};
        for (int round = 0; round < 3000; ++round) {
            std::string text = sound;
            const int changes = round % 3 == 0 ? 1 : round % 3 == 1 ? 3 : 30;
            for (int i = 0; i < changes; ++i)
                text[random() % text.size()] = static_cast<char>(random() % 256);
            QVERIFY2(answersSoundly(decode, text), text.c_str());
        }
    }

    void staysSoundWherePartsAreMissingOrTwice_data() { addDecoders(); }
    void staysSoundWherePartsAreMissingOrTwice()
    {
        QFETCH(Decode, decode);
        QFETCH(std::string, sound);
        std::mt19937 random{9};
        for (int round = 0; round < 1000; ++round) {
            std::string text = sound;
            const std::size_t from = random() % text.size();
            const std::size_t length = random() % 40;
            if (round % 2 == 0)
                text.erase(from, length);
            else
                text.insert(random() % text.size(), sound.substr(from, length));
            QVERIFY2(answersSoundly(decode, text), text.c_str());
        }
    }
};

CARINA_TEST(TestDamagedLandmarks)

} // namespace carina::damaged_landmarks_test

#include "tst_damaged_landmarks.moc"
