#include "models/vitals/kept_sounds.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::kept_sounds_test
{

class TestKeptSounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void remembersEachKindByItself()
    {
        const test::ScratchFolder folder;
        KeptSounds sounds{folder.path()};
        sounds.keep(SoundKind::Oximeter, {35, false});
        sounds.keep(SoundKind::Alarm, {80, true});
        const KeptSounds next{folder.path()};
        QCOMPARE(next.of(SoundKind::Oximeter), (KeptSounds::Loudness{35, false}));
        QCOMPARE(next.of(SoundKind::Alarm), (KeptSounds::Loudness{80, true}));
        QCOMPARE(next.of(SoundKind::Breath), KeptSounds::Loudness{});
        QCOMPARE(next.of(SoundKind::Heart), KeptSounds::Loudness{});
    }

    void soundsAsUsualWhereTheFileIsDamaged()
    {
        const test::ScratchFolder folder;
        folder.write("sounds.ini", "[oximeter]\nvolume=loud\n[alarm]\nvolume=4000\n");
        const KeptSounds sounds{folder.path()};
        QCOMPARE(sounds.of(SoundKind::Oximeter), KeptSounds::Loudness{});
        QCOMPARE(sounds.of(SoundKind::Alarm).volume_percent, 100);
    }

    void remembersNothingWithoutAFolder()
    {
        KeptSounds sounds;
        sounds.keep(SoundKind::Heart, {10, true});
        QCOMPARE(sounds.of(SoundKind::Heart).volume_percent, 10);
        QCOMPARE(KeptSounds{}.of(SoundKind::Heart), KeptSounds::Loudness{});
    }
};

CARINA_TEST(TestKeptSounds)

} // namespace carina::kept_sounds_test

#include "tst_kept_sounds.moc"
