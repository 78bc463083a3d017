#include "tests/support/test_class.h"
#include "ui/lesson/lesson_scene.h"

namespace carina::lesson_scene_test
{
namespace
{

std::vector<ScenePart> parts(std::uint16_t count)
{
    std::vector<ScenePart> all(count);
    for (std::uint16_t i = 0; i < count; ++i)
        all[i].id = static_cast<std::uint16_t>(i + 1);
    return all;
}

SceneSettings sample()
{
    SceneSettings settings;
    settings.section = Section{-Vec3::UnitX(), 0.03, Cut::AllButAirway};
    for (std::uint16_t hidden = 3; hidden <= 5; ++hidden)
        settings.looks[hidden] = {.style = PartStyle::Hidden};
    settings.looks[6] = {.style = PartStyle::Ghost, .labelled = true};
    settings.looks[9] = {.highlighted = true, .labelled = true, .plain = true};
    return settings;
}

} // namespace

class TestLessonScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsOthersWhatIsDrawn()
    {
        const Lesson lesson = lessonOf(sample());
        QCOMPARE(lesson.looks.size(), std::size_t{3}); // parts in a row are one
        QVERIFY(settingsOf(lesson, parts(20)) == sample());
        QVERIFY(settingsOf(lessonOf({}), parts(20)) == SceneSettings{});
    }

    void leavesOutPartsThatAreNotThere()
    {
        const SceneSettings settings = settingsOf(lessonOf(sample()), parts(4));
        QCOMPARE(settings.looks.size(), std::size_t{2});
        Lesson all;
        all.looks = {{1, 0xffff, LessonStyle::Ghost}};
        QCOMPARE(settingsOf(all, parts(4)).looks.size(), std::size_t{4});
    }

    void hasNoMoreLooksThanAFactHasRoomFor()
    {
        SceneSettings settings;
        for (std::uint16_t part = 1; part <= 3 * kMostLessonLooks; ++part)
            settings.looks[part] = {.style = PartStyle::Ghost, .labelled = part % 2 == 0};
        QCOMPARE(lessonOf(settings).looks.size(), kMostLessonLooks);
    }

    void looksAsACameraDoes()
    {
        CameraPose camera;
        camera.p_A_eye = {0.3, -2.0, 0.1};
        camera.p_A_target = {0.0, 0.0, 0.2};
        const RigidTransform X_AD = viewpointOf(camera);
        const Vec3 ahead = (camera.p_A_target - camera.p_A_eye).normalized();
        QVERIFY((X_AD.rotation() * -Vec3::UnitZ() - ahead).norm() < 1e-12);
        QVERIFY((X_AD.rotation() * Vec3::UnitY()).dot(camera.up_A) > 0.9);
        QVERIFY(X_AD.translation() == camera.p_A_eye);
    }

    /// Its shaft comes from the side of the eye, and does not hide the point.
    void pointsFromBesideTheCamera()
    {
        CameraPose camera;
        camera.p_A_eye = {0.0, -2.0, 0.0};
        const Vec3 p_A{0.1, 0.0, 0.1};
        const RigidTransform X_AP = pointingAt(p_A, camera);
        QVERIFY(X_AP.translation() == p_A);
        const Vec3 shaft = X_AP.rotation() * Vec3::UnitZ();
        QVERIFY(shaft.y() < -0.5 && shaft.x() > 0.3 && shaft.z() > 0.3);
    }
};

CARINA_TEST(TestLessonScene)

} // namespace carina::lesson_scene_test

#include "tst_lesson_scene.moc"
