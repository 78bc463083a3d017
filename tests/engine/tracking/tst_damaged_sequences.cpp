#include "engine/tracking/sequence_file.h"

#include "tests/engine/tracking/sequence_text.h"
#include "tests/support/test_class.h"

#include <random>
#include <sstream>

namespace carina::damaged_sequences_test
{
namespace
{

/// Three frames of two tools, one of them lost for a while.
std::string soundText()
{
    return test::SequenceText{}
        .frame("12.5")
        .toolAt("Stylus", "10", "-20", "30.25")
        .tool("Reference", "0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1", "MISSING")
        .frame("12.75")
        .toolAt("Stylus", "11", "-20", "30.25")
        .tool("Reference", "0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1")
        .frame("13")
        .tool("Stylus", "", "INVALID")
        .tool("Reference", "0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1")
        .text();
}

/// Whether the reader either refuses the text, naming it, or gives poses that are finite and in
/// order.
bool answersSoundly(const std::string& text)
{
    std::istringstream input{text};
    const Result<TrackerSequence> sequence = readSequence(input, "damaged");
    if (!sequence)
        return sequence.error().detail.starts_with("damaged: ");
    for (const RecordedTool& tool : sequence->tools) {
        SessionTime last = SessionTime::min();
        for (const PoseSample& sample : tool.samples) {
            if (!sample.X_FO.matrix().allFinite() || sample.time < last)
                return false;
            last = sample.time;
        }
    }
    return !sequence->tools.empty();
}

} // namespace

/// The reader of .igs.mha on damaged bytes: seeded, so that a failure can be had again.
class DamagedSequencesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTheUndamagedText()
    {
        std::istringstream input{soundText()};
        QVERIFY(readSequence(input, "sound"));
    }

    void refusesEveryTextThatIsCutOff()
    {
        const std::string sound = soundText();
        const std::size_t complete = sound.find("ElementDataFile =");
        for (std::size_t length = 0; length <= complete; ++length) {
            std::istringstream input{sound.substr(0, length)};
            QVERIFY(!readSequence(input, "cut off"));
        }
    }

    void staysSoundWhereBytesAreChanged_data()
    {
        QTest::addColumn<int>("changes");
        QTest::newRow("one byte") << 1;
        QTest::newRow("three bytes") << 3;
        QTest::newRow("thirty bytes") << 30;
    }
    void staysSoundWhereBytesAreChanged()
    {
        QFETCH(int, changes);
        const std::string sound = soundText();
        std::mt19937 random{7};
        for (int round = 0; round < 3000; ++round) {
            std::string text = sound;
            for (int i = 0; i < changes; ++i)
                text[random() % text.size()] = static_cast<char>(random() % 256);
            QVERIFY2(answersSoundly(text), text.c_str());
        }
    }

    void staysSoundWhereNumbersAreChanged()
    {
        const std::string sound = soundText();
        std::mt19937 random{8};
        const std::array<std::string, 8> numbers{
            "1e308", "-1e308", "nan", "-inf", "18446744073709551615", "-1", "1e-320", "0x1p3"};
        for (int round = 0; round < 3000; ++round) {
            std::string text = sound;
            const std::size_t digit = text.find_first_of("0123456789", random() % text.size());
            if (digit != std::string::npos)
                text.replace(digit, 1, numbers[random() % numbers.size()]);
            QVERIFY2(answersSoundly(text), text.c_str());
        }
    }

    void staysSoundWhereLinesAreMissingRepeatedOrSwapped()
    {
        std::vector<std::string> lines;
        std::istringstream sound{soundText()};
        for (std::string line; std::getline(sound, line);)
            lines.push_back(line);
        std::mt19937 random{9};
        for (int round = 0; round < 1000; ++round) {
            std::vector<std::string> shuffled = lines;
            shuffled[random() % shuffled.size()] = lines[random() % lines.size()];
            std::swap(shuffled[random() % shuffled.size()], shuffled[random() % shuffled.size()]);
            std::string text;
            for (const std::string& line : shuffled)
                text += line + "\n";
            QVERIFY2(answersSoundly(text), text.c_str());
        }
    }
};

CARINA_TEST(DamagedSequencesTest)

} // namespace carina::damaged_sequences_test

#include "tst_damaged_sequences.moc"
