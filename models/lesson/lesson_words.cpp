#include "models/lesson/lesson_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace carina
{
namespace
{

QString lessonWords(const char* text) { return QCoreApplication::translate("LessonWords", text); }

template <class Wanted> bool hasLook(const Lesson& lesson, Wanted wanted)
{
    return std::ranges::any_of(lesson.looks, wanted);
}

bool isSeeThrough(const LessonLook& look)
{
    return look.style == LessonStyle::Ghost && !look.isHighlighted;
}

bool isHidden(const LessonLook& look)
{
    return look.style == LessonStyle::Hidden && !look.isHighlighted;
}

} // namespace

QString lessonText(const Lesson& lesson, bool pointer)
{
    QStringList shown;
    const auto add = [&shown](bool isShown, const char* text) {
        if (isShown)
            shown += lessonWords(text);
    };
    add(lesson.section.isCut, QT_TRANSLATE_NOOP("LessonWords", "section"));
    add(hasLook(lesson, [](const LessonLook& look) { return look.isHighlighted; }),
        QT_TRANSLATE_NOOP("LessonWords", "highlights"));
    add(hasLook(lesson, [](const LessonLook& look) { return look.isNamed; }),
        QT_TRANSLATE_NOOP("LessonWords", "names"));
    add(hasLook(lesson, isHidden), QT_TRANSLATE_NOOP("LessonWords", "parts hidden"));
    add(hasLook(lesson, isSeeThrough), QT_TRANSLATE_NOOP("LessonWords", "parts seen through"));
    add(lesson.showsView, QT_TRANSLATE_NOOP("LessonWords", "view"));
    add(pointer, QT_TRANSLATE_NOOP("LessonWords", "pointer"));
    return shown.isEmpty() ? lessonWords(QT_TRANSLATE_NOOP("LessonWords", "the patient as usual"))
                           : shown.join(lessonWords(QT_TRANSLATE_NOOP("LessonWords", ", ")));
}

QString lessonNotice(const StationMoment& moment, bool followsView)
{
    if (!moment.lesson)
        return {};
    const bool pointer = std::ranges::any_of(moment.people, [](const PersonPose& person) {
        return person.kind == ObjectKind::Pointer && !person.isOwn
               && person.pose.validity != Validity::Lost;
    });
    Lesson shown = moment.lesson->lesson;
    shown.showsView = shown.showsView && followsView;
    return lessonWords(QT_TRANSLATE_NOOP("LessonWords", "● The instructor shows: %1"))
        .arg(lessonText(shown, pointer));
}

} // namespace carina
