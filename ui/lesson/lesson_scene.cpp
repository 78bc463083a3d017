#include "ui/lesson/lesson_scene.h"

namespace carina
{
namespace
{

constexpr double kBeside = 0.6; ///< of what points: how far it comes from the right and from above

LessonLook lookOf(std::uint16_t part, const PartLook& look)
{
    return {part,          part,      static_cast<LessonStyle>(look.style), look.highlighted,
            look.labelled, look.plain};
}

PartLook lookOf(const LessonLook& look)
{
    return {static_cast<PartStyle>(look.style), look.isHighlighted, look.isNamed, look.isPlain};
}

bool continues(const LessonLook& before, const LessonLook& look)
{
    LessonLook joined = before;
    joined.first = look.first;
    joined.last = look.last;
    return joined == look && before.last + 1 == look.first;
}

static_assert(static_cast<int>(PartStyle::Hidden) == static_cast<int>(LessonStyle::Hidden));
static_assert(static_cast<int>(Cut::AllButAirway) == static_cast<int>(LessonCut::AllButAirway));

/// A pose that looks along -back, with +x to the right.
RigidTransform lookingAway(const Vec3& back, const Vec3& right, const Vec3& p_A)
{
    Mat3 R;
    R << right, back.cross(right), back;
    return {Quat{R}, p_A};
}

} // namespace

Lesson lessonOf(const SceneSettings& settings)
{
    Lesson lesson;
    if (const auto& section = settings.section)
        lesson.section = {true,
                          static_cast<LessonCut>(section->cut),
                          {section->normal_A.x(), section->normal_A.y(), section->normal_A.z()},
                          section->distance};
    for (const auto& [part, look] : settings.looks) {
        if (look == PartLook{} || part == 0)
            continue;
        const LessonLook next = lookOf(part, look);
        if (!lesson.looks.empty() && continues(lesson.looks.back(), next))
            lesson.looks.back().last = part;
        else if (lesson.looks.size() < kMostLessonLooks)
            lesson.looks.push_back(next);
    }
    return lesson;
}

SceneSettings settingsOf(const Lesson& lesson, std::span<const ScenePart> parts)
{
    SceneSettings settings;
    if (lesson.section.isCut)
        settings.section = Section{Vec3{lesson.section.normal_A.data()}, lesson.section.distance,
                                   static_cast<Cut>(lesson.section.cut)};
    for (const ScenePart& part : parts)
        for (const LessonLook& look : lesson.looks)
            if (look.first <= part.id && part.id <= look.last)
                settings.looks.emplace(part.id, lookOf(look));
    return settings;
}

RigidTransform viewpointOf(const CameraPose& camera)
{
    const Vec3 back = (camera.p_A_eye - camera.p_A_target).normalized();
    const Vec3 right = camera.up_A.cross(back).normalized();
    return lookingAway(back, right, camera.p_A_eye);
}

RigidTransform pointingAt(const Vec3& p_A, const CameraPose& camera)
{
    const Mat3 R_AD = viewpointOf(camera).rotation().toRotationMatrix();
    const Vec3 back = (R_AD * Vec3{kBeside, kBeside, 1.0}).normalized();
    const Vec3 right = R_AD.col(1).cross(back).normalized();
    return lookingAway(back, right, p_A);
}

} // namespace carina
