#include "models/tracker/kept_sound.h"

#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::kept_sound_test
{

class TestKeptSound : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isOnUnlessItWasSilenced()
    {
        const test::ScratchFolder folder;
        KeptSound sound{folder.path()};
        QVERIFY(sound.isOn());
        sound.keep(false);
        QVERIFY(!sound.isOn());
        QVERIFY(!KeptSound{folder.path()}.isOn()); // at the next start
        sound.keep(true);
        QVERIFY(KeptSound{folder.path()}.isOn());
    }

    void leavesNoFileBehindThatNobodyAskedFor()
    {
        const test::ScratchFolder folder;
        QVERIFY(KeptSound{folder.path()}.isOn());
        QVERIFY(!QFileInfo::exists(folder.filePath("tracking.ini")));
    }

    void isOnWhereTheFileIsDamaged()
    {
        const test::ScratchFolder folder;
        folder.write("tracking.ini", "no settings");
        QVERIFY(KeptSound{folder.path()}.isOn());
    }

    void remembersNothingWithoutAFolder()
    {
        KeptSound sound;
        sound.keep(false);
        QVERIFY(!sound.isOn());
        QVERIFY(KeptSound{}.isOn());
    }
};

CARINA_TEST(TestKeptSound)

} // namespace carina::kept_sound_test

#include "tst_kept_sound.moc"
