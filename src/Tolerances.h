// SPDX-License-Identifier: MIT
// The tolerances and tuned constants that no user meets: name, unit, reason, consequence. Nothing else in src
// holds one; those that users meet are in <Shapes/Limits.h>.
#pragma once

#include <Shapes/Limits.h>

#include <cstddef>

namespace Shapes {

/// Largest approach speed in a response, in units per second: a surface may be faster than any ball. The
/// speed that a response adds, at most 1e37 with the largest elasticities, stays finite together with the
/// ball's own; that is far above g_fMaxSpeed, to which the ball is cut.
inline constexpr float g_fMaxApproach = 1e25f;

/// Angle from an arc's end ray, in radians, up to which a point counts as in the sector; twice that for rays
/// along a diagonal, because lengths are sums of coordinates there. The angles of the ends are rounded by up
/// to 1 ulp of one radian, so an arc that goes on from a segment leaves no gap.
inline constexpr float g_fSectorRounding = 2.5f * 1.1920929e-7f;

/// Two angles whose difference is a whole turn to this share of their sizes are a full circle, dimensionless:
/// two roundings of each. An arc that lacks less than that of a full turn counts as one.
inline constexpr float g_fFullTurnRounding = 2.0f * 1.1920929e-7f;

/// Padding of boxes in the broad phase, relative to their largest coordinate plus the radius of the ball. The
/// pair kernels err by less, so a contact that they would report is never lost to a box.
inline constexpr float g_fBoxPadding = 16.0f * 1.1920929e-7f;

/// How far a ball may be moved by responses before its candidates are collected again, in its radii. The
/// result is the same for any value. Counted by callgrind: a ball that lies on a floor costs 36% fewer
/// instructions than with 0, 100 balls among 64 shapes 1% fewer; 1 gains nothing more.
inline constexpr float g_fCandidateSlack = 0.25f;

/// An overlap, or an approach by the end of a substep, of up to this share of the coordinates and radii
/// involved is rounding where Continuous runs, dimensionless: places are floats between the substeps, and
/// what turns is rounded up to eight times. Balls are set back by it without a contact.
inline constexpr float g_fTouchRounding = 0x1p-21f;

/// Hops in a substep of a ball that slides along the inside of an arc or a turning shape where Continuous
/// runs. It is off its way by (v dt / g_nHops)^2 / (8 R). Under gravity a ball whose hop would be shorter
/// than that part of the substep makes none: it loses at most (closing acceleration dt / g_nHops)^2 / 8 of
/// its energy per mass, once.
inline constexpr unsigned g_nHops = 16;
/// Steepest hop, in radians: bounces that are steeper are never taken for sliding.
inline constexpr float g_fShallow = 0.01f;
/// Largest turn, in radians, of a surface or of a ball along it, after which the way of a ball that slides is
/// computed anew. It is a parabola in between, off by the turn cubed times the radius / 6 at most.
inline constexpr float g_fHoldTurn = 0.03125f;
/// The same where it slides along one that does not turn: its parabola knows how its acceleration changes
/// there, and is off by the turn cubed times the radius / 40 on the way. At the end it is put to where a
/// pendulum is, within the fifth power of the turn.
inline constexpr float g_fSlideTurn = 0.125f;
/// Most rounds of Newton's method in which it is put along a curve to where it meets another shape, the gap,
/// in roundings of its place, with which it is there, and the least sine of the angle between the two.
inline constexpr int g_nSlideRounds = 8;
inline constexpr double g_fSlideGap = 0x1p-20;
inline constexpr double g_fSlideSlope = 1e-3;
/// Most of these parts in a substep.
inline constexpr unsigned g_nMaxHolds = 64;
/// Speed below which a ball that lies on something is at rest where Continuous runs, as a share of what
/// gravity gives in a substep, and the seconds after which it sleeps, if all of its pile has been at rest so
/// long. At 60 substeps a second it does not come to that on a slope of .2 degrees, with longer ones on one
/// in proportion.
inline constexpr double g_fSleepSpeed = 0.05;
inline constexpr float g_fSleepTime = 0.5f;
/// Changes between two substeps, beyond which all balls wake, instead of those near the changes.
inline constexpr std::size_t g_nMostDisturbed = 1024;
/// Overlap, in radii of the smaller ball, with which none falls asleep: those of a pile are still being moved
/// apart, little by little where their masses differ by 1,000 times. Without it 3 of 1,600 random piles slept
/// with .0011 to .0058.
inline constexpr double g_fSleepOverlap = 1e-3;
/// Seconds after which they sleep all the same: balls in a lane that is too narrow for them have nowhere to
/// go. Level rows a thousandth too long need up to 17 s to come apart.
inline constexpr float g_fPressedSleepTime = 30.0f;
/// Two balls rest on each other if they approach or part by no more than gravity gives in so many substeps,
/// and would touch within one. With 1 a pile of 200 does not come to rest.
inline constexpr double g_fRestingSteps = 2.0;
/// That is of elastic balls. Others may approach faster, up to what leaves them no faster bounce: by the
/// square of the largest elasticity, or by this if that is less. With 1 a pile in an hourglass takes 1.14
/// times as long. The gap stays: else 60 falling balls take .07 more time.
inline constexpr double g_fLeastBounce = 0.5;
/// Two that rest on each other and are hit come into each other by less than this share of the smaller radius
/// in the rest of a substep, or it is an impact; and two that slide along each other follow the curve by no
/// more. In steps of .03 to .1 s that leaves overlaps of .1 radii and more to 1 of 70 piles, without the
/// latter to 1 of 10; .02 would take 10% more time in shorter ones.
inline constexpr double g_fPassedOverlap = 0.05;
/// How far a ball of a pile, which moves straight, is led in a substep from its way by a surface that curves
/// towards it, as a share of the radius of that curve: half of the square of the angle by which it turns,
/// here half a radian. By more than that the ball has impacts with it instead: else it is led through what
/// lies on its other side. Without this 4 of 880 rings in which bars turn lose one.
inline constexpr double g_fMostInward = 0.125;
/// Most impacts in a substep of a ball of a pile, or of one that loses speed and is near others: for the rest
/// of it it is halted. Bounds the time of a pile that falls together or is squeezed by a wall. Through a neck
/// of four diameters 300 balls flow at .72 of the rate without this bound with 16, at .89 of it with 64, for
/// up to an eighth more time.
inline constexpr unsigned g_nCrowded = 64;
/// A ball that is halted within this share of a substep has got nowhere in it: it is stuck, and has no
/// velocity. In slots that are too narrow by a rounding they are halted within 6e-6 at most.
inline constexpr double g_fStuckPart = 1e-4;
/// Impacts in that share of a substep, all along one line, of a ball that a moving shape pushes, after which
/// it is halted: it is pressed on another one, and would bounce between them without end.
inline constexpr unsigned g_nStuckImpacts = 16;
/// By how much the cosine of the angle of two normals on one line may differ from 1 or -1: roundings of them.
/// Between surfaces that are not parallel a ball gets out at a side.
inline constexpr double g_fOnLine = 1e-12;
/// A ball that has found so many others near it in a substep, again after each impact, is halted at its next
/// one: bounds the time of balls in one place. In a pile, which leaves each a few neighbours, it has had
/// g_nCrowded impacts before.
inline constexpr std::size_t g_nMostBallsSeen = 4096;
/// A ball that is deep in more others than this, by half of the smaller radius, is in a crowd. Of a crowd it
/// meets the nearest balls and those that it is among the nearest of, and it does not sleep: in a pile there
/// is no room for that.
inline constexpr std::size_t g_nMostDeep = 32;
/// How far balls of a crowd may go until what is near them is looked for again, in the largest radius: they
/// are moved dozens of times among all others as they are parted. With 0 a step of 2,000 balls in one place
/// takes ten times as long, with 4 they come apart later.
inline constexpr double g_fCrowdSlack = 2.0;
/// By how much discs around balls, and their ways, are larger where near ones are looked for, as a share of
/// their radius: so far a ball gets until it is looked for anew. With none piles take .04 more time, with
/// twice as much 60 falling balls .015.
inline constexpr float g_fNearSlack = 0.05f;
/// A correction of the place of a ball by more than this share of its radius, out of a shape or in a pile,
/// might take it into another shape, and is swept. In a pile, where balls move each other, the shapes that
/// near are looked at, in the largest radius of the ball and those that it touches.
inline constexpr double g_fFarCorrection = 0.25;
/// Farthest that a ball of a pile is moved out of others in a substep, in the same radius: less than
/// g_fFarCorrection. In its own one small balls stay behind as large ones go: 10,000 of radii 1:10 that have
/// come into each other in a fall of 30 units sink on, to half of their height.
inline constexpr double g_fMostSeparation = 0.2;
/// But so many times as far as a shape was put into one of them. With 0 a cup of 30 balls that SetPos moves
/// to and fro by .4 radii a step spills 136 of 240, with 1 and more none; by .8 radii it spills 90, with 1
/// 81, with 1.5 19, with 2 25, with 5 35.
inline constexpr double g_fGivenWay = 1.5;
/// How far a ball may be from a surface that curves, in its radii, to be put back onto it after a part of its
/// way along it. More than the parabola leaves it; beyond it the ball has left, or is deep in what has left
/// it no room.
inline constexpr double g_fSettleReach = 0.01;
/// Sine of the angle below which two surfaces that hold a ball are parallel: they may cross far away, where
/// they all but contradict each other.
inline constexpr double g_fParallel = 0.05;
/// The same where one of the two is another ball, which gives way: else the ball is squeezed out between them
/// at the speed of their approach over this sine.
inline constexpr double g_fSteep = 0.5;
/// Two balls that what holds them lets give way to each other by less than this share of what they would
/// freely, do not: they would be squeezed out aside at that over a sine.
inline constexpr double g_fLeastGiven = 0.05;
/// Most rounds of the solver in which balls of piles that overlap are moved apart, and the overlap, in radii,
/// that may remain. With 16 piles of masses 1:1000 keep overlaps of .1 and do not come to rest, and boxes of
/// 1,000 take half as long again.
inline constexpr std::size_t g_nSeparateRounds = 64;
inline constexpr double g_fSeparateError = 2e-4;
/// Share of the impulses that have moved balls apart in the last substep with which the search for the next
/// ones begins, unless any of them flows: what these rounds do not come to in one substep they do in several.
/// With 0 1 of 60 piles of masses 1:1000 in a V sinks as fast as it is moved apart, up to .1 radii deep,
/// without end; with 1 a step gives 3e-4 of the energy of some.
inline constexpr double g_fKnownApart = 0.8;
/// Contacts of a ball, in the mean, above which these rounds become fewer: the time of a step in which many
/// are put in one place. In a pile of equal balls it is at most 3.
inline constexpr std::size_t g_nManyContacts = 8;
/// Overlap of two balls of a pile, in the smaller radius, above which the upper one is also lifted as they
/// are moved apart, by this much for each unit aside: a wall squeezes them in a row. Where both are slow
/// enough to sleep, and the sine of the angle of their row is below g_fLevel, g_fSleepOverlap is enough:
/// without that 8 of 40 piles on a floor that is a thousandth too narrow for a row of 21 balls keep overlaps
/// of .004 for ever. Were steeper ones lifted, too, piles of masses 1:1000 in a V would not come to rest.
inline constexpr double g_fSqueezedDepth = 0.25;
inline constexpr double g_fLevel = 0.02;
inline constexpr double g_fLift = 0.25;
/// Most rounds of the solver of resting contacts, and the change of a velocity in one, as a share of what is
/// slow, after which it has come to an end. A tower of 100 needs 300 until it presses with its weight, 50
/// balls in a box need some ten.
inline constexpr std::size_t g_nRestingRounds = 300;
inline constexpr double g_fRestingError = 1e-3;
/// The same change as a share of the speed of the fastest ball of the pile, above half of what is slow: a
/// pile that flows need not be as exact as one that comes to rest. With .03 a pile of 200 in a V takes twice
/// as long to come to rest, with 0 each step takes twice as long while it flows. Balls that overlap are moved
/// apart as exactly, by the fastest of all piles.
inline constexpr double g_fFlowError = 0.01;
/// Most rounds of the solver for such a pile. With 300, as for one that is slow, piles of masses 1:1000 take
/// 1.1 to 1.3 times as long, and overlap as much; with 60 as long as with 100, and 1,000 in a box rest late.
inline constexpr std::size_t g_nFlowRounds = 100;
/// Rounds after which, and after each doubling of them, it is looked whether shapes that push leave no room:
/// no velocities of use fulfil all contacts. The search for all overlaps ends where one pile proves it. With
/// 8 or 32 a pile under a paddle takes .98 to 1.04 of the instructions.
inline constexpr std::size_t g_nPossibleRounds = 16;
/// Part of what a contact lacks that a round gives to it once there is momentum. With all of it both feed
/// what alternates from ball to ball: crystals of 40 rows end in nonsense, with .9 those of 80; with .8 those
/// of 120 do not yet. Less takes more rounds.
inline constexpr double g_fRelaxation = 0.8;
/// A round that changes so many times what the first one has ends the momentum of a search: where each ball
/// is in dozens of others it diverges nevertheless, and impulses that are remembered end as NaN after 20
/// substeps. Of 25,000 searches in piles 12 come to it.
inline constexpr double g_fMostGrowth = 2.0;
/// Where it has come no nearer to its end than to so many times that change, that many rounds from the bottom
/// up follow in which the lower one of two balls does not give way (shock propagation). Without them balls
/// of 1,000 times the mass press the others through each other.
inline constexpr double g_fShock = 10.0;
inline constexpr int g_nShockRounds = 2;
/// Impacts in a substep of a ball that touches others, after which it is squeezed between what comes upon it
/// and what gives no way, and no longer becomes faster than the fastest ball was at the beginning of the
/// substep, or than so many times the surfaces that were met. Exactly it would leave at the speed of their
/// approach over the sine of the angle between them, which is small for an instant only.
inline constexpr unsigned g_nSqueezed = 8;
inline constexpr double g_fSqueezed = 2.0;
/// Gap, in radii of the smaller one, up to which a ball that was squeezed in the last substep and what is
/// near it are solved together, beyond what they move against each other now: so far others may push it. With
/// 0 a paddle among 200 balls has twice as many impacts. What is near is found so far by g_fNearSlack of
/// both.
inline constexpr double g_fSqueezedReach = 0.1;
/// Approach of two balls, as a share of what gravity gives in a substep, up to which they do not meet again
/// in one in which one of them has had g_nSqueezed impacts: inelastic ones would ever more slowly, without
/// end. They overlap by that in the next one, at 60 substeps a second by less than a thousandth of a radius
/// of .2. Without it nine of ten impacts in a box of 200 inelastic balls approach at less than 1/128.
inline constexpr double g_fLeastApproach = 0x1p-4;
/// Change of the velocity of a ball between two substeps, as a share of it and above what gravity
/// gives in one, by which a game steers it: less may be a drag.
inline constexpr double g_fSteered = 0.1;
/// Last rounds in which only shapes push: a ball in a wedge is pushed by both sides in turns.
inline constexpr int g_nWedgeRounds = 8;

/// Most straight parts of the path of a ball, between two of its vertices, in the frame of a turning sensor:
/// bounds time where a sensor turns hundreds of times in a substep. The path is coarser than
/// g_fRotatedPathError then.
inline constexpr int g_nMaxTurnParts = 1024;

/// A gap of that many roundings (in double) of the coordinates is touching in a sweep, and approach speeds of
/// as many roundings of the speeds are none, dimensionless. Larger than the sum of some hundred impacts;
/// at 1 unit from the origin it is 1.4e-14 units.
inline constexpr int g_nSweepRoundings = 64;
/// Error of the distance to a shape that is surely far, above that of any kernel, as a share of the
/// coordinates, dimensionless.
inline constexpr double g_fFarRounding = 0x1p-40;
/// Most steps of the search for an impact with one part of a turning shape. Ten in the mean; some dozen for
/// each whole turn. Bounds time where a shape turns hundreds of times in a step.
inline constexpr int g_nMaxAdvancementSteps = 4096;

/// Share of its coordinates that a point may be off what it lies on and touch it: two times what the native
/// engine keeps it away.
inline constexpr float g_fPointReach = 8.0f * 1.1920929e-7f;
/// Steps after which a search with what touches the ball all the time looks at it less and less often: the
/// overlap that it may miss grows by this factor from rounding on. Without that a ball at rest at the end
/// about which a flipper turns took all steps, and one step of 30 balls 53 ms.
inline constexpr int g_nTouchingSteps = 64;
inline constexpr double g_fTouchingGrowth = 1.5;

/// Largest turn, in radians, that is asked of b2TimeOfImpact at once.
inline constexpr float g_fLargestTurn = 0.125f;

/// Share of Box2D's longest move that a ball is to make in one of its steps in a tuned world, dimensionless:
/// what gravity and an impact add within the step is taken into account, their rounding is not.
inline constexpr float g_fSafeMove = 0.95f;

/// Most parts into which a tuned world cuts a substep for Box2D. A ball or a shape that is still too fast is
/// slowed down by Box2D, and reported: CWorldStats::m_nMovesClamped, m_nTurnsClamped.
inline constexpr unsigned g_nMaxAdaptiveSubsteps = 256;

/// How far the stand-ins of a ball and of a shape in a tuned world reach beyond them together, in slops of
/// Box2D
/// (.005 metres). Box2D stops two of them 3 slops deep, within a quarter of one: at 2.5 the shapes themselves
/// have just met, and what only touches is not stopped.
inline constexpr float g_fSkinSlops = 2.5f;

/// A relative move in a step that is shorter than this share of Box2D's slop, or of twice the way that a ball
/// falls in its first step, is a press and no impact in a tuned world. With a tenth a pile that is pressed
/// together is taken for impacts and comes apart; with 1 slow elastic impacts gain three times the energy (8%
/// in 10,000).
inline constexpr float g_fPressMove = 0.5f;

/// Balls whose gap is at most that many slops touch in a tuned world: somewhat more than their skins, so that
/// what Box2D solves together is lasting together.
inline constexpr float g_fLastingReach = 3.0f;
/// A ball is crowded in a tuned world if so many others are within that many radii (of the smaller one): in a
/// row each has two, in a pile four to six.
inline constexpr int g_nCrowd = 3;
inline constexpr float g_fNearInRadii = 0.25f;

/// Rounds in which a ball in lasting contact is pushed out of several shapes.
inline constexpr int g_nPushRounds = 8;

/// How deep a ball in lasting contact may get into a shape, in its radii, before it is stopped there.
inline constexpr float g_fLastingDepth = 0.5f;

/// A step of a tuned world is cut if two balls in lasting contact would get deeper into each other by more
/// than that many radii (of the smaller one), and into so many parts at most. In piles of 10 to 200 that
/// settle in a box, a V and a bowl the largest overlap is .08 to .41 radii then (shipped .14 to 2.0), for at
/// most 1.5 times the time of shipped; .05 halves some overlaps for up to a tenth more time, and 8 parts gain
/// nothing.
inline constexpr float g_fLastingMove = 0.1f;
inline constexpr float g_fMostLastingSubsteps = 4.0f;

/// Two balls in lasting contact in a tuned world are crushed if they overlap by that many radii (of the
/// smaller one): their normal is tilted by so much then (a sine), one up and the next one down, so that a row
/// on a floor that walls press together gives way. Without it twenty balls between two gates end up 1
/// to 1.3 radii deep in each other, with it at most half of one.
inline constexpr float g_fCrushed = 0.2f;
inline constexpr float g_fCrushedTilt = 0.1f;

/// A ball in a tuned world whose radius is below this share of a slop is kept off a surface on which it lies
/// by the rest of that: rounding would decide on which side of it its centre is.
inline constexpr float g_fLeastRest = 0.25f;

/// Resting thresholds of a tuned world, as multiples of g dt: the largest approach speed at which a
/// ball rests on a surface; the same of an elastic ball, which rests only where it would bounce more than
/// once in a step; and the largest speed at which a ball leaves the surface and still rests.
inline constexpr double g_fRestingSpeed = 1.5;
inline constexpr double g_fElasticRestingSpeed = 0.5;
inline constexpr double g_fLiftSpeed = 0.25;

/// Two unit tangents that are closer than that are one: rounding of rotation, dimensionless.
inline constexpr float g_fSameTangent = 1e-4f;

/// How far a body of Box2D may be from its shape by rounding, as a share of their coordinates.
inline constexpr float g_fBodyRounding = 32.0f * 1.1920929e-7f;

/// Most chords for one arc on Box2D: bounds memory where an arc is huge and the tolerance small. The arc is
/// coarser than the tolerance then.
inline constexpr int g_nMaxArcPieces = 4096;

/// Shortest edge that Box2D is given, in metres: twice the distance of vertices below which it stops the
/// program. Anything shorter becomes a point.
inline constexpr float g_fShortestEdge = 0.01f;

/// Largest turn, in radians, of a corner of an imported chain, or of two edges that share an end, that gets
/// no guard point: 20 degrees. A ball that rolls over a guarded corner bounces off the point; at one without
/// a guard a native ball of radius r falls r (1 / cos(10 degrees) - 1) = .016 r deeper at most before it is
/// met.
inline constexpr float g_fSmoothTurn = 0.349f;

/// Restitution that an import aims at for a pair that has 0 in Box2D, but whose members both bounce
/// elsewhere, so that neither can have elasticity 0. Their partners get elasticities of up to 32 times (the
/// inverse of the root of it) their restitution.
inline constexpr float g_fNearlyDead = 0.0009765625f;

/// Eigenvalue below which a direction is free in the equations that elasticities come from, dimensionless.
/// Their coefficients are 0, 1 and 2: for n unknowns the smallest that is not 0 is about 1/n^2, rounding
/// gives 1e-15 n^2 at most.
inline constexpr double g_fFreeEigenvalue = 1e-10;

/// Most that elasticity adds to a velocity on Box2D, in metres per second: above the largest speed, to which
/// a ball is cut in the end; intermediate values inside Box2D stay finite.
inline constexpr float g_fMaxBox2DSpeedGain = 4e9f;

/// Length of a motion in which nothing turns, seconds: how far a ball may be pushed is asked as a motion.
inline constexpr double g_fInstant = 0x1p-80;
/// Cells of the grid of shapes for each of them, and in all at least and at most: finer cells clear more
/// places, and cost more to make.
inline constexpr std::size_t g_nCellsPerShape = 48, g_nLeastCells = 4096, g_nMostCells = 1 << 18;
/// Most of them in a row or a column.
inline constexpr std::size_t g_nMostColumns = 4096;
/// Half the diagonal of a cell over its side, rounded up.
inline constexpr float g_fHalfDiagonal = 0.7072f;
/// Error of the distances in the grid of shapes, as a share of the largest coordinate in it: of the kernels,
/// the closest point on a shape and the place of a cell together.
inline constexpr float g_fGridPadding = 64.0f * 1.1920929e-7f;
/// Largest coordinate in that grid, user units: the square of a distance in it is far from the largest float.
inline constexpr float g_fLargestGrid = 1e12f;
/// How far the grid of shapes reaches with Continuous, in radii of the largest ball: what is farther is asked
/// of the tree.
inline constexpr float g_fGridReach = 4.5f;
/// That grid is made anew when it reaches this many times as far as it need.
inline constexpr float g_fMostGridReach = 4.5f;
/// Questions to the tree before the grid is made. Among few shapes they cost little, and for a few trials of
/// a ball it would not pay.
inline constexpr std::size_t g_nAskedBeforeGrid = 1024;
/// Substeps that the grid of shapes has to last before threads share it, for which all of its cells are
/// filled.
inline constexpr unsigned g_nBeforeSharing = 16;
/// Lanes for each thread, and balls in a lane at least.
inline constexpr std::size_t g_nLanesPerThread = 4, g_nLeastInLane = 512;
/// Shapes that have come or moved since the grid or the tree was made, or kinematic ones, that are looked at
/// one by one. Beyond it the tree is asked, or both are made anew: 5 ms with 4,000.
inline constexpr std::size_t g_nMostLoose = 64;
/// One of so many static shapes may be a removed one that is kept until all boxes are made anew: with 4,000
/// that takes 1 ms.
inline constexpr std::size_t g_nLeastKeptShare = 4;
/// Rounds in which a ball that overlaps several shapes is set back from all of them. If that is not enough,
/// there is no room.
inline constexpr int g_nSetBackRounds = 8;
/// Most discs in the grid of balls for each of them, before it is made anew of those that count.
inline constexpr std::size_t g_nMostDiscs = 2;
/// Discs of which each is looked at, because that costs less than to find the cells.
inline constexpr std::size_t g_nFewDiscs = 24;
/// Levels of cells of that grid, and the powers of two of the diameter that share one; smaller balls share
/// the last one. Among balls of equal radii, at different speeds, more levels cost more than they spare.
inline constexpr std::size_t g_nMostLevels = 4;
inline constexpr int g_nPowersPerLevel = 3;
/// A substep is cut where a shape comes to its stop, unless one of the parts would be shorter than this share
/// of it: then the shape is as much slower or, if it is at its stop already but for that, as good as at rest.
inline constexpr float g_fLeastPart = 1.0f / 256.0f;
/// Gap that rounding may leave between a shape that comes to its stop and the stop, as a share of its move.
inline constexpr double g_fStopRounding = 1e-5;
/// A ball that is let through may get deeper by this share of its overlap until its approach is found.
inline constexpr double g_fDeeper = 1e-4;

} // namespace Shapes
